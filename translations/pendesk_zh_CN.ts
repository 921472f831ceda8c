<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
<context>
    <name>Actions</name>
    <message>
        <source> or </source>
        <translation> 或 </translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD（软件）</translation>
    </message>
    <message>
        <source>Access level…</source>
        <translation>访问级别…</translation>
    </message>
    <message>
        <source>Open this page in its own window</source>
        <translation>在单独的窗口中打开此页面</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>连接…</translation>
    </message>
    <message>
        <source>Connect to this controller</source>
        <translation>连接到此控制器</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>断开连接</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>打开演示</translation>
    </message>
    <message>
        <source>Diagnose…</source>
        <translation>诊断…</translation>
    </message>
    <message>
        <source>Copy diagnosis</source>
        <translation>复制诊断结果</translation>
    </message>
    <message>
        <source>About Pendesk</source>
        <translation>关于 Pendesk</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>Language and look…</source>
        <translation>语言和外观…</translation>
    </message>
    <message>
        <source>Readiness…</source>
        <translation>就绪状态…</translation>
    </message>
    <message>
        <source>Help and shortcuts</source>
        <translation>帮助和快捷键</translation>
    </message>
</context>
<context>
    <name>Alarms</name>
    <message>
        <source>Major</source>
        <translation>重故障</translation>
    </message>
    <message>
        <source>Minor</source>
        <translation>轻故障</translation>
    </message>
    <message>
        <source>User, system</source>
        <translation>用户（系统）</translation>
    </message>
    <message>
        <source>User</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>Off-line</source>
        <translation>离线</translation>
    </message>
    <message>
        <source>◆ unacknowledged</source>
        <translation>◆ 未确认</translation>
    </message>
    <message>
        <source>■ acknowledged</source>
        <translation>■ 已确认</translation>
    </message>
    <message>
        <source>▲ cleared, unacknowledged</source>
        <translation>▲ 已消除，未确认</translation>
    </message>
    <message>
        <source>□ cleared</source>
        <translation>□ 已消除</translation>
    </message>
    <message>
        <source>No sub code.</source>
        <translation>无子代码。</translation>
    </message>
    <message>
        <source>%1: %2. As sent: %3, type %4.</source>
        <translation>%1：%2。原始数据：%3，类型 %4。</translation>
    </message>
</context>
<context>
    <name>Conditions</name>
    <message>
        <source>%1: %2.</source>
        <comment>what is wrong: what helps</comment>
        <translation>%1：%2。</translation>
    </message>
    <message>
        <source>met</source>
        <translation>满足</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>不满足</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>尚未读取</translation>
    </message>
    <message>
        <source>cannot be read over HSES</source>
        <translation>无法通过 HSES 读取</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>what was tried: how it ended</comment>
        <translation>%1：%2。</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>激活</translation>
    </message>
    <message>
        <source>Reset alarm</source>
        <translation>报警复位</translation>
    </message>
    <message>
        <source>Cancel error</source>
        <translation>解除错误</translation>
    </message>
    <message>
        <source>Write a signal</source>
        <translation>写入信号</translation>
    </message>
    <message>
        <source>Write a register</source>
        <translation>写入寄存器</translation>
    </message>
    <message>
        <source>Write a variable</source>
        <translation>写入变量</translation>
    </message>
    <message>
        <source>Select a job</source>
        <translation>选择程序</translation>
    </message>
    <message>
        <source>Select a master job</source>
        <translation>选择主程序</translation>
    </message>
    <message>
        <source>Start the job</source>
        <translation>启动程序</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD（软件）</translation>
    </message>
    <message>
        <source>Release HOLD</source>
        <translation>解除 HOLD</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>接通伺服</translation>
    </message>
    <message>
        <source>Servo off</source>
        <translation>断开伺服</translation>
    </message>
    <message>
        <source>HLOCK on</source>
        <translation>开启 HLOCK</translation>
    </message>
    <message>
        <source>HLOCK off</source>
        <translation>关闭 HLOCK</translation>
    </message>
    <message>
        <source>Select the cycle mode</source>
        <translation>选择循环模式</translation>
    </message>
    <message>
        <source>Show a message on the pendant</source>
        <translation>在示教编程器上显示信息</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Send a file to the controller</source>
        <translation>向控制器发送文件</translation>
    </message>
    <message>
        <source>Get a file from the controller</source>
        <translation>从控制器获取文件</translation>
    </message>
    <message>
        <source>Delete a file on the controller</source>
        <translation>删除控制器上的文件</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>恢复备份</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>监视</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Engineer</source>
        <translation>工程师</translation>
    </message>
    <message>
        <source>disarmed by hand</source>
        <translation>手动取消激活</translation>
    </message>
    <message>
        <source>nobody used key or mouse for a minute</source>
        <translation>一分钟内无键盘或鼠标操作</translation>
    </message>
    <message>
        <source>another program came to the front</source>
        <translation>其他软件切换到了前台</translation>
    </message>
    <message>
        <source>the screen was locked</source>
        <translation>屏幕已锁定</translation>
    </message>
    <message>
        <source>communication was lost</source>
        <translation>通信中断</translation>
    </message>
    <message>
        <source>the mode changed at the controller</source>
        <translation>控制器的模式已改变</translation>
    </message>
    <message>
        <source>an alarm came up</source>
        <translation>发生了报警</translation>
    </message>
    <message>
        <source>the access level fell back</source>
        <translation>访问级别已回退</translation>
    </message>
    <message>
        <source>another window came to the front</source>
        <translation>其他窗口切换到了前台</translation>
    </message>
    <message>
        <source>another controller was armed</source>
        <translation>激活了另一台控制器</translation>
    </message>
    <message>
        <source>The link to the controller is up</source>
        <translation>与控制器的链路正常</translation>
    </message>
    <message>
        <source>The access level is Operate or Engineer</source>
        <translation>访问级别为“操作”或“工程师”</translation>
    </message>
    <message>
        <source>The access level is Engineer</source>
        <translation>访问级别为“工程师”</translation>
    </message>
    <message>
        <source>The status is fresh</source>
        <translation>状态为最新</translation>
    </message>
    <message>
        <source>This controller is armed</source>
        <translation>此控制器已激活</translation>
    </message>
    <message>
        <source>REMOTE is on</source>
        <translation>REMOTE 已接通</translation>
    </message>
    <message>
        <source>The mode is PLAY</source>
        <translation>模式为 PLAY</translation>
    </message>
    <message>
        <source>The mode is not TEACH</source>
        <translation>模式不是 TEACH</translation>
    </message>
    <message>
        <source>There is no alarm</source>
        <translation>没有报警</translation>
    </message>
    <message>
        <source>There is no error</source>
        <translation>没有错误</translation>
    </message>
    <message>
        <source>Not held by the pendant</source>
        <translation>示教编程器未保持 HOLD</translation>
    </message>
    <message>
        <source>Not held by an external signal</source>
        <translation>外部信号未保持 HOLD</translation>
    </message>
    <message>
        <source>Not held by a command</source>
        <translation>命令未保持 HOLD</translation>
    </message>
    <message>
        <source>Held by a command</source>
        <translation>由命令保持 HOLD</translation>
    </message>
    <message>
        <source>Servo power is on</source>
        <translation>伺服电源已接通</translation>
    </message>
    <message>
        <source>No job is running</source>
        <translation>没有程序在运行</translation>
    </message>
    <message>
        <source>A job is selected</source>
        <translation>已选择程序</translation>
    </message>
    <message>
        <source>The numbering of variables is verified</source>
        <translation>变量编号已验证</translation>
    </message>
    <message>
        <source>The model takes move orders</source>
        <translation>该机型接受移动命令</translation>
    </message>
    <message>
        <source>The safety circuit is closed</source>
        <translation>安全回路已闭合</translation>
    </message>
    <message>
        <source>Not held by a playback panel</source>
        <translation>再现操作面板未保持 HOLD</translation>
    </message>
    <message>
        <source>Home position and position check are confirmed</source>
        <translation>原点位置和位置确认均已完成</translation>
    </message>
    <message>
        <source>Starting is not locked at the panel</source>
        <translation>面板未锁定启动</translation>
    </message>
    <message>
        <source>Mode and cycle are not locked at the panel</source>
        <translation>面板未锁定模式和循环</translation>
    </message>
    <message>
        <source>Selecting a job in REMOTE and PLAY is permitted</source>
        <translation>允许在 REMOTE 和 PLAY 时选择程序</translation>
    </message>
    <message>
        <source>Changing the master job is permitted</source>
        <translation>允许更改主程序</translation>
    </message>
    <message>
        <source>The job exists on the controller</source>
        <translation>控制器上存在该程序</translation>
    </message>
    <message>
        <source>Nothing is being edited at the pendant</source>
        <translation>示教编程器上没有正在编辑的内容</translation>
    </message>
    <message>
        <source>No other function uses the files</source>
        <translation>没有其他功能正在使用文件</translation>
    </message>
    <message>
        <source>The data are not protected</source>
        <translation>数据未受保护</translation>
    </message>
    <message>
        <source>Replacing existing files is permitted</source>
        <translation>允许替换已有文件</translation>
    </message>
    <message>
        <source>There is no link to the controller</source>
        <translation>与控制器没有链路</translation>
    </message>
    <message>
        <source>connect, or wait until it answers again</source>
        <translation>请连接，或等待其再次应答</translation>
    </message>
    <message>
        <source>The access level is Monitor</source>
        <translation>访问级别为“监视”</translation>
    </message>
    <message>
        <source>switch to Operate in the strip (Ctrl+L)</source>
        <translation>请在状态条中切换到“操作”(Ctrl+L)</translation>
    </message>
    <message>
        <source>The access level is not Engineer</source>
        <translation>访问级别不是“工程师”</translation>
    </message>
    <message>
        <source>switch to Engineer in the strip (Ctrl+L)</source>
        <translation>请在状态条中切换到“工程师”(Ctrl+L)</translation>
    </message>
    <message>
        <source>The status was not read just now</source>
        <translation>刚才未读取到状态</translation>
    </message>
    <message>
        <source>wait a moment; if it stays so, look at the link</source>
        <translation>请稍候；如果仍然如此，请检查链路</translation>
    </message>
    <message>
        <source>This controller is not armed</source>
        <translation>此控制器未激活</translation>
    </message>
    <message>
        <source>arm it on this page</source>
        <translation>请在此页面上激活</translation>
    </message>
    <message>
        <source>REMOTE is off</source>
        <translation>REMOTE 已断开</translation>
    </message>
    <message>
        <source>turn the pendant key to REMOTE and switch on CMD REMOTE SEL: %1</source>
        <translation>请将示教编程器的钥匙开关转到 REMOTE，并接通 CMD REMOTE SEL：%1</translation>
    </message>
    <message>
        <source>The mode is not PLAY</source>
        <translation>模式不是 PLAY</translation>
    </message>
    <message>
        <source>turn the pendant key to PLAY or REMOTE</source>
        <translation>请将示教编程器的钥匙开关转到 PLAY 或 REMOTE</translation>
    </message>
    <message>
        <source>The controller is in TEACH</source>
        <translation>控制器处于 TEACH</translation>
    </message>
    <message>
        <source>the person at the pendant has the robot: turn the key to REMOTE when that is over</source>
        <translation>机器人由示教编程器旁的人员控制：请在其操作结束后将钥匙开关转到 REMOTE</translation>
    </message>
    <message>
        <source>There is an alarm</source>
        <translation>有报警</translation>
    </message>
    <message>
        <source>remove its cause, then reset it on the Alarms page</source>
        <translation>请消除其原因，然后在“报警”页面上复位</translation>
    </message>
    <message>
        <source>There is an error</source>
        <translation>有错误</translation>
    </message>
    <message>
        <source>read it on the Alarms page, then cancel it</source>
        <translation>请在“报警”页面上查看，然后解除</translation>
    </message>
    <message>
        <source>Held by the pendant</source>
        <translation>由示教编程器保持 HOLD</translation>
    </message>
    <message>
        <source>release it there</source>
        <translation>请在该处解除 HOLD</translation>
    </message>
    <message>
        <source>Held by an external signal</source>
        <translation>由外部信号保持 HOLD</translation>
    </message>
    <message>
        <source>release it where that signal comes from</source>
        <translation>请在该信号的来源处解除</translation>
    </message>
    <message>
        <source>release HOLD on the Jobs page</source>
        <translation>请在“程序”页面上解除 HOLD</translation>
    </message>
    <message>
        <source>No command holds the robot</source>
        <translation>没有命令使机器人保持 HOLD</translation>
    </message>
    <message>
        <source>there is nothing to release from here</source>
        <translation>此处没有可解除的 HOLD</translation>
    </message>
    <message>
        <source>Servo power is off</source>
        <translation>伺服电源已断开</translation>
    </message>
    <message>
        <source>switch servo on</source>
        <translation>请接通伺服</translation>
    </message>
    <message>
        <source>A job is running</source>
        <translation>有程序正在运行</translation>
    </message>
    <message>
        <source>wait until it has ended, or hold it</source>
        <translation>请等待其结束，或执行 HOLD</translation>
    </message>
    <message>
        <source>No job is selected</source>
        <translation>未选择程序</translation>
    </message>
    <message>
        <source>select one on the Jobs page</source>
        <translation>请在“程序”页面上选择一个程序</translation>
    </message>
    <message>
        <source>The numbering of variables is not verified</source>
        <translation>变量编号未验证</translation>
    </message>
    <message>
        <source>compare two variables with the pendant (Variables page)</source>
        <translation>请将两个变量与示教编程器比较（“变量”页面）</translation>
    </message>
    <message>
        <source>This model takes no move orders</source>
        <translation>此机型不接受移动命令</translation>
    </message>
    <message>
        <source>move it with the pendant</source>
        <translation>请用示教编程器移动</translation>
    </message>
    <message>
        <source>The safety circuit is open</source>
        <translation>安全回路已断开</translation>
    </message>
    <message>
        <source>look at emergency stops, doors and the enabling switch</source>
        <translation>请检查急停、安全门和使能开关</translation>
    </message>
    <message>
        <source>Held by a playback panel</source>
        <translation>由再现操作面板保持 HOLD</translation>
    </message>
    <message>
        <source>Home position or position check is missing</source>
        <translation>缺少原点位置或位置确认</translation>
    </message>
    <message>
        <source>confirm the position at the pendant</source>
        <translation>请在示教编程器上确认位置</translation>
    </message>
    <message>
        <source>Starting is locked at the panel</source>
        <translation>面板已锁定启动</translation>
    </message>
    <message>
        <source>release the start lock (I/O or panel prohibit) at the cell</source>
        <translation>请在机器人单元处解除启动锁定（I/O 或面板禁止）</translation>
    </message>
    <message>
        <source>Mode and cycle are locked at the panel</source>
        <translation>面板已锁定模式和循环</translation>
    </message>
    <message>
        <source>release the panel lock (I/O or panel prohibit) at the cell</source>
        <translation>请在机器人单元处解除面板锁定（I/O 或面板禁止）</translation>
    </message>
    <message>
        <source>Selecting a job in REMOTE and PLAY is prohibited</source>
        <translation>禁止在 REMOTE 和 PLAY 时选择程序</translation>
    </message>
    <message>
        <source>set “job select when remote and play” to permit: %1</source>
        <translation>请将“job select when remote and play”设为允许：%1</translation>
    </message>
    <message>
        <source>Changing the master job is prohibited</source>
        <translation>禁止更改主程序</translation>
    </message>
    <message>
        <source>permit it at the pendant (master call, teach lock): %1</source>
        <translation>请在示教编程器上允许（主程序调用、示教锁定）：%1</translation>
    </message>
    <message>
        <source>The job is not on the controller</source>
        <translation>控制器上没有该程序</translation>
    </message>
    <message>
        <source>read the list of jobs again</source>
        <translation>请重新读取程序列表</translation>
    </message>
    <message>
        <source>Something is being edited at the pendant</source>
        <translation>示教编程器上有正在编辑的内容</translation>
    </message>
    <message>
        <source>leave the editor there</source>
        <translation>请在示教编程器上退出编辑</translation>
    </message>
    <message>
        <source>Another function uses the files</source>
        <translation>其他功能正在使用文件</translation>
    </message>
    <message>
        <source>try again in a moment</source>
        <translation>请稍后重试</translation>
    </message>
    <message>
        <source>The data are protected</source>
        <translation>数据受保护</translation>
    </message>
    <message>
        <source>release the protection at the pendant</source>
        <translation>请在示教编程器上解除保护</translation>
    </message>
    <message>
        <source>Replacing files is not permitted</source>
        <translation>不允许替换文件</translation>
    </message>
    <message>
        <source>set the parameters RS029 and RS214 to 1: %1</source>
        <translation>请将参数 RS029 和 RS214 设为 1：%1</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION COND. or FUNCTION ENABLE</source>
        <translation>SETUP，FUNCTION COND. 或 FUNCTION ENABLE</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION ENABLE</source>
        <translation>SETUP，FUNCTION ENABLE</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION COND. or TEACHING COND.</source>
        <translation>SETUP，FUNCTION COND. 或 TEACHING COND.</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION ENABLE or TEACHING COND.</source>
        <translation>SETUP，FUNCTION ENABLE 或 TEACHING COND.</translation>
    </message>
    <message>
        <source>PARAMETER, RS (management mode)</source>
        <translation>PARAMETER，RS（管理模式）</translation>
    </message>
    <message>
        <source>IN/OUT, PSEUDO INPUT SIG, CMD REMOTE SEL (#82015 on a DX100)</source>
        <translation>IN/OUT，PSEUDO INPUT SIG，CMD REMOTE SEL（DX100 上为 #82015）</translation>
    </message>
    <message>
        <source>The controller shows an error</source>
        <translation>控制器显示有错误</translation>
    </message>
    <message>
        <source>The controller shows no error</source>
        <translation>控制器未显示错误</translation>
    </message>
    <message>
        <source>there is nothing to cancel</source>
        <translation>没有可解除的内容</translation>
    </message>
    <message>
        <source>the connection was closed</source>
        <translation>连接已关闭</translation>
    </message>
    <message>
        <source>the language was changed</source>
        <translation>语言已更改</translation>
    </message>
    <message>
        <source>the window was turned to another controller</source>
        <translation>窗口切换到了另一台控制器</translation>
    </message>
    <message>
        <source>the computer went to sleep</source>
        <translation>计算机进入了睡眠状态</translation>
    </message>
    <message>
        <source>this program stood still, or the computer&apos;s clock jumped</source>
        <translation>本软件曾停止响应，或计算机时钟发生跳变</translation>
    </message>
</context>
<context>
    <name>FileSheet</name>
    <message>
        <source>There is no “%1”.</source>
        <translation>没有“%1”。</translation>
    </message>
    <message>
        <source>There is no folder “%1”.</source>
        <translation>没有文件夹“%1”。</translation>
    </message>
    <message>
        <source>“%1” exists already. Is it to be replaced?</source>
        <translation>“%1”已存在。是否替换？</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
</context>
<context>
    <name>LinkView</name>
    <message>
        <source>checking</source>
        <translation>正在检查</translation>
    </message>
    <message>
        <source>live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>communication lost</source>
        <translation>通信中断</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>未连接</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>Diagnose…</source>
        <translation>诊断…</translation>
    </message>
    <message>
        <source>HOLD not confirmed: use the pendant.</source>
        <translation>HOLD 未得到确认：请使用示教编程器。</translation>
    </message>
    <message>
        <source>HOLD was refused: %1. Use the pendant.</source>
        <translation>HOLD 被拒绝：%1。请使用示教编程器。</translation>
    </message>
    <message>
        <source>No contact with %1 yet: %2. Checking goes on by itself.</source>
        <translation>尚未与 %1 建立通信：%2。将自动继续检查。</translation>
    </message>
    <message>
        <source>Checking %1: waiting for system information and status.</source>
        <translation>正在检查 %1：等待系统信息和状态。</translation>
    </message>
    <message>
        <source>Communication lost at %1 — showing the last values read. Reading resumes by itself.</source>
        <translation>%1 处通信中断 — 显示的是最后读取的值。将自动恢复读取。</translation>
    </message>
    <message numerus="yes">
        <source>Communication restored at %1. Lost %n time(s) since connecting.</source>
        <translation>
            <numerusform>%1 处通信已恢复。自连接以来中断 %n 次。</numerusform>
        </translation>
    </message>
    <message>
        <source>HOLD was not sent: there is no connection to a controller. Use the pendant.</source>
        <translation>HOLD 未发送：没有与控制器的连接。请使用示教编程器。</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>连接…</translation>
    </message>
</context>
<context>
    <name>Noise</name>
    <message>
        <source>Date of the last change of a job (///DATE)</source>
        <translation>程序的最后更改日期 (///DATE)</translation>
    </message>
    <message>
        <source>Dates and times of day, such as 2026/01/31 08:30</source>
        <translation>日期和时刻，例如 2026/01/31 08:30</translation>
    </message>
    <message>
        <source>Operating time counters, such as 18:19&apos;02</source>
        <translation>运行时间计数器，例如 18:19&apos;02</translation>
    </message>
    <message>
        <source>Blanks at the end of a line</source>
        <translation>行末空格</translation>
    </message>
    <message>
        <source>Line ends: CR LF or LF, and whether the last line has one</source>
        <translation>行尾：CR LF 或 LF，以及最后一行是否有行尾</translation>
    </message>
</context>
<context>
    <name>OrderRecords</name>
    <message>
        <source>✓ done</source>
        <translation>✓ 完成</translation>
    </message>
    <message>
        <source>✗ refused</source>
        <translation>✗ 被拒绝</translation>
    </message>
    <message>
        <source>▲ unknown</source>
        <translation>▲ 未知</translation>
    </message>
    <message>
        <source>□ not sent</source>
        <translation>□ 未发送</translation>
    </message>
    <message>
        <source>□ cancelled</source>
        <translation>□ 已取消</translation>
    </message>
</context>
<context>
    <name>Page</name>
    <message>
        <source>kept on this computer</source>
        <translation>保存在本计算机上</translation>
    </message>
    <message>
        <source>the last values read before %1</source>
        <translation>%1 之前最后读取的值</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Overview</source>
        <translation>概览</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>I/O</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>寄存器</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Jog and move</source>
        <translation>点动和移动</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>趋势</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>The state of the robot at a glance: mode, cycle, servo, run, the three causes of a hold, alarm, error and speed limit, the executing job, the position of R1, and how well the link works.</source>
        <translation>机器人状态一览：模式、循环、伺服、运行、HOLD 的三种来源、报警、错误和速度限制、正在执行的程序、R1 的位置，以及链路的工作情况。</translation>
    </message>
    <message>
        <source>“What can I do now?” lists what may be ordered. ✓ may be tried, ✗ may not, with the first reason beside it.</source>
        <translation>“现在可以做什么？”列出可以发送的命令。✓ 表示可以尝试，✗ 表示不可以，旁边给出第一个原因。</translation>
    </message>
    <message>
        <source>Bits that contradict each other, such as TEACH and PLAY, are shown side by side as they were received, under ▲.</source>
        <translation>相互矛盾的位（例如 TEACH 和 PLAY）按接收到的原样并列显示，并带有 ▲。</translation>
    </message>
    <message>
        <source>Copy beside the system information takes model and software to the clipboard. The right mouse button on a number adds it to the trend.</source>
        <translation>系统信息旁的“复制”将机型和软件复制到剪贴板。在数值上使用鼠标右键可将其添加到趋势。</translation>
    </message>
    <message>
        <source>Up to four active alarms, the newest first, and the past alarms that were read from the controller.</source>
        <translation>最多四个当前报警，最新的在前，以及从控制器读取的过去的报警。</translation>
    </message>
    <message>
        <source>Acknowledge is noted on this computer only: the robot does not hear of it.</source>
        <translation>“确认”仅记录在本计算机上，不会通知机器人。</translation>
    </message>
    <message>
        <source>Reset alarm and Cancel error are orders: they need REMOTE and the level Operate, and say before what they clear. After a reset that was accepted an alarm may stay: then its cause is still there.</source>
        <translation>“报警复位”和“解除错误”是命令：需要 REMOTE 和“操作”级别，并会事先说明将清除的内容。复位被接受后报警可能仍在：此时其原因尚未消除。</translation>
    </message>
    <message>
        <source>Read now fetches the history and keeps it in the journal, even after the controller has dropped it. Most frequent counts codes.</source>
        <translation>“立即读取”获取履历并保存在日志中，即使控制器之后已将其删除也会保留。“最频繁”按代码统计次数。</translation>
    </message>
    <message>
        <source>Notes keep what caused a code and what was done, on this computer.</source>
        <translation>“备注”记录某个代码的原因和采取的措施，保存在本计算机上。</translation>
    </message>
    <message>
        <source>All signals of one area, a group of eight in a row. A filled square is 1, a hollow one 0; a frame marks what changed in the last two seconds.</source>
        <translation>一个区域的所有信号，每行一组八个。实心方块为 1，空心方块为 0；边框标出最近两秒内改变的信号。</translation>
    </message>
    <message>
        <source>Only network inputs can be written over HSES, by an engineer. A write reads the group, changes one bit, shows old and new, and reads back: eight bits travel together.</source>
        <translation>通过 HSES 只能写入网络输入，且需要“工程师”级别。写入时先读取该组，改变一位，显示旧值和新值，然后回读：八位成组传送。</translation>
    </message>
    <message>
        <source>Names come from the controller&apos;s IONAME.DAT. The right mouse button names a signal here, or puts it on the tab Watch.</source>
        <translation>名称来自控制器的 IONAME.DAT。使用鼠标右键可在本机为信号命名，或将其放到“关注”选项卡上。</translation>
    </message>
    <message>
        <source>Watch counts edges and draws the last minute. It reads four times a second: shorter pulses are not seen.</source>
        <translation>“关注”对边沿计数，并绘制最近一分钟。每秒读取四次：更短的脉冲检测不到。</translation>
    </message>
    <message>
        <source>Go to takes #27010 as well as IN#(1).</source>
        <translation>“转到”可输入 #27010，也可输入 IN#(1)。</translation>
    </message>
    <message>
        <source>The registers M000 to M999, as decimal, signed, hexadecimal or binary numbers. Only the rows in view are read.</source>
        <translation>寄存器 M000 至 M999，以十进制、有符号、十六进制或二进制数显示。仅读取可见的行。</translation>
    </message>
    <message>
        <source>M000 to M559 can be written by an engineer; the others belong to the ladder.</source>
        <translation>M000 至 M559 可由工程师写入；其余属于梯形图。</translation>
    </message>
    <message>
        <source>Enter in the editor stages a value: it turns amber and nothing is sent. Apply shows old and new of all staged values, writes each once, and reads it back.</source>
        <translation>在编辑器中按 Enter 会暂存一个值：该值变为琥珀色，不发送任何内容。“应用”显示所有暂存值的旧值和新值，每个值写入一次并回读。</translation>
    </message>
    <message>
        <source>A value that reads back differently is red and stays. Undo last stages the values from before the last Apply.</source>
        <translation>回读不一致的值显示为红色并保留。“撤销上次”暂存上次“应用”之前的值。</translation>
    </message>
    <message>
        <source>The variables B I D R S P BP and EX with their names, their value before, and when they changed. Only the rows in view are read.</source>
        <translation>变量 B I D R S P BP 和 EX，及其名称、上一值和改变时间。仅读取可见的行。</translation>
    </message>
    <message>
        <source>Nothing is written before the numbering was compared with the pendant: Verify… does that, and only reads.</source>
        <translation>与示教编程器比较编号之前，不写入任何内容：“验证…”进行该比较，且仅进行读取。</translation>
    </message>
    <message>
        <source>Import and Export take CSV files; cells of a spreadsheet can be pasted. Both show first what would differ.</source>
        <translation>“导入”和“导出”使用 CSV 文件；也可粘贴电子表格的单元格。导入和粘贴都会先显示将有的差异。</translation>
    </message>
    <message>
        <source>A watch page is a list of your own: the right mouse button puts rows of any tab on it.</source>
        <translation>关注页是您自己的列表：使用鼠标右键可将任意选项卡中的行放到关注页上。</translation>
    </message>
    <message>
        <source>The tool point in the base frame, with form and tool; the axes in pulses with following error, torque and temperature where the model tells them; and the path of the tool point.</source>
        <translation>基座坐标下的工具控制点，及其形态和工具；以脉冲表示的轴，以及机型提供时的跟随误差、转矩和温度；工具控制点的轨迹。</translation>
    </message>
    <message>
        <source>Degrees of axes stand here only where the profile gives pulses per degree: the controller does not tell them.</source>
        <translation>仅当配置中给出每度脉冲数时，此处才显示轴的度数：控制器不提供度数。</translation>
    </message>
    <message>
        <source>Torque is shown as the controller sends it: its unit is stated nowhere.</source>
        <translation>转矩按控制器发送的原样显示：单位未见任何说明。</translation>
    </message>
    <message>
        <source>Min and max count from the last reset, while this page is read. Copy as text takes the table in view.</source>
        <translation>“最小”和“最大”自上次重置起统计，且仅在读取此页面期间统计。“复制为文本”复制当前显示的表格。</translation>
    </message>
    <message>
        <source>Control groups that the controller refuses have no tab; the line beside the tabs counts them.</source>
        <translation>被控制器拒绝的控制轴组没有选项卡；选项卡旁的一行显示其数量。</translation>
    </message>
    <message>
        <source>Moves the robot by orders, in automatic operation. The pendant&apos;s enabling switch does not protect anyone here, and nobody may be inside the fence. It is off in TEACH, always.</source>
        <translation>在自动运行中通过命令移动机器人。示教编程器的使能开关（安全开关）在此不保护任何人，任何人不得在安全围栏内。在 TEACH 下始终不可用。</translation>
    </message>
    <message>
        <source>Arming needs the level Operate, REMOTE and PLAY; moving needs Engineer too. Losing the focus, a minute without a key or the mouse, an alarm or a lost link disarms.</source>
        <translation>激活需要“操作”级别、REMOTE 和 PLAY；移动还需要“工程师”级别。失去焦点、一分钟内无键盘或鼠标操作、发生报警或链路中断时，将取消激活。</translation>
    </message>
    <message>
        <source>Jog sends one bounded step after another while a button is held. Letting go sends no more steps and holds the one that runs; after a lost link the robot still ends its step.</source>
        <translation>按住按钮期间，“点动”逐步发送有限步距的移动。松开后不再发送新的步，并对正在执行的一步执行 HOLD；链路中断后，机器人仍会走完当前这一步。</translation>
    </message>
    <message>
        <source>Move shows present place, target and change first. Rehearse… opens the sheet on which the move is confirmed.</source>
        <translation>“移动”先显示当前位置、目标和变化量。“预检…”打开确认移动的对话框。</translation>
    </message>
    <message>
        <source>What was sent without an answer is called unknown, never failed: look at the robot.</source>
        <translation>已发送但没有应答的操作称为“未知”，绝不称为失败：请查看机器人。</translation>
    </message>
    <message>
        <source>Draws any number over time. Drag it here from a page, choose “Add to trend” in its menu, or use Add signal….</source>
        <translation>绘制任意数值随时间的变化。可从某个页面将数值拖到此处，在其菜单中选择“添加到趋势”，或使用“添加信号…”。</translation>
    </message>
    <message>
        <source>Pause freezes the view; recording goes on. Gaps in a curve are times in which nothing was read.</source>
        <translation>“暂停”冻结视图；记录继续进行。曲线中的间断表示该时段未读取任何内容。</translation>
    </message>
    <message>
        <source>The time box chooses how long a time is in view; under the cursor stand the values of that moment.</source>
        <translation>时间框选择视图显示的时间长度；同时显示光标所在时刻的值。</translation>
    </message>
    <message>
        <source>An incident keeps 60 s before and 20 s after an alarm came up. It can be opened here later.</source>
        <translation>事件保存发生报警前 60 s 和后 20 s 的内容。之后可在此处打开。</translation>
    </message>
    <message>
        <source>Export CSV… writes what is in view, with times in UTC.</source>
        <translation>“导出 CSV…”写出视图中的内容，时间为 UTC。</translation>
    </message>
    <message>
        <source>The jobs on the controller and the text of the chosen one, with the line that is executed. A banner says when the text may be old.</source>
        <translation>控制器上的程序，以及所选程序的内容和正在执行的行。内容可能已过时时，会显示横幅提示。</translation>
    </message>
    <message>
        <source>Start needs REMOTE, PLAY, servo on, the level Operate and an armed controller. Its sheet names controller, job and line, and the button works after one second. Nothing is ever started twice.</source>
        <translation>“启动”需要 REMOTE、PLAY、伺服已接通、“操作”级别以及控制器已激活。其对话框写明控制器、程序和行，按钮在一秒后才可用。绝不会重复启动。</translation>
    </message>
    <message>
        <source>Buttons show what was read. “Pending” stands until the status agrees.</source>
        <translation>按钮显示读取到的状态。在状态与请求一致之前，显示“等待中”。</translation>
    </message>
    <message>
        <source>HOLD from here can be released here. A hold by the pendant is released there.</source>
        <translation>从此处执行的 HOLD 可在此处解除。由示教编程器保持的 HOLD 在示教编程器上解除。</translation>
    </message>
    <message>
        <source>“Why not?” beside a button lists all its conditions.</source>
        <translation>按钮旁的“为什么不可以？”列出其所有条件。</translation>
    </message>
    <message>
        <source>Files of this computer on the left, of the controller on the right, by type.</source>
        <translation>左侧为本计算机的文件，右侧为控制器的文件，按类型显示。</translation>
    </message>
    <message>
        <source>Fetch only reads. Send and Delete are for engineers and need REMOTE on.</source>
        <translation>“获取”仅进行读取。“发送”和“删除”需要“工程师”级别，且 REMOTE 已接通。</translation>
    </message>
    <message>
        <source>A file that exists already is asked about: compare it, replace it, or leave it, which is the default. A file cut off half way never replaces a good one.</source>
        <translation>文件已存在时会询问：比较、替换，或保留不变（默认）。中途截断的文件绝不会替换完好的文件。</translation>
    </message>
    <message>
        <source>Before a job is sent its text is checked, and afterwards it is read back and compared.</source>
        <translation>发送程序之前检查其内容，发送之后回读并比较。</translation>
    </message>
    <message>
        <source>Transfers lists every file with its bytes and state. Retry failed sends none that was finished.</source>
        <translation>“传输”列出每个文件及其字节数和状态。“重试失败项”不会发送已完成的文件。</translation>
    </message>
    <message>
        <source>Backups of this controller, the newest first, with the files that are missing in each. ▲ marks one that is not whole.</source>
        <translation>此控制器的备份，最新的在前，并列出每个备份中缺少的文件。▲ 标出不完整的备份。</translation>
    </message>
    <message>
        <source>Back up now reads every file into a new folder with a checksum of each. A file that fails does not stop the rest.</source>
        <translation>“立即备份”将每个文件读取到新文件夹中，并为每个文件记录校验和。某个文件失败不会中止其余文件。</translation>
    </message>
    <message>
        <source>Verify reads every byte again. Compare finds what differs from another backup or from the controller now; dates and counters are left out, and the page says which.</source>
        <translation>“验证”重新读取每个字节。“比较”找出与另一个备份或与当前的控制器之间的差异；日期和计数器不计入，页面会说明不计入的内容。</translation>
    </message>
    <message>
        <source>Restore… plans first, makes a fresh backup, sends what changed, and reads it back. It needs an engineer and REMOTE, and no job may run.</source>
        <translation>“恢复…”先制定计划，做一次新的备份，发送已改变的内容，然后回读。需要“工程师”级别和 REMOTE，且没有程序在运行。</translation>
    </message>
    <message>
        <source>Old backups go by number and age as set below the list, never the last good one or a pinned one.</source>
        <translation>旧备份按列表下方设定的数量和时间删除；最后一个完好的备份和已固定的备份绝不会被删除。</translation>
    </message>
    <message>
        <source>Everything that was tried from here: writes, starts, moves, servo, files, and what was refused or withheld, with user, old and new value, and the controller&apos;s answer.</source>
        <translation>从此处尝试过的所有操作：写入、启动、移动、伺服、文件，以及被拒绝或未发送的操作，并附有操作者、旧值、新值和控制器的应答。</translation>
    </message>
    <message>
        <source>“Unknown” means that no answer came: it may have happened.</source>
        <translation>“未知”表示没有收到应答：操作可能已执行。</translation>
    </message>
    <message>
        <source>Filter by controller, kind, time and outcome, or search in all texts. Older records come when scrolling down.</source>
        <translation>可按控制器、内容、时间和结果筛选，或搜索所有文本。向下滚动时会显示更早的记录。</translation>
    </message>
    <message>
        <source>The journal is kept on this computer for all controllers and can be read without a connection. Export writes what the filter shows.</source>
        <translation>所有控制器的日志都保存在本计算机上，无需连接即可查看。“导出”写出符合筛选条件的记录。</translation>
    </message>
    <message>
        <source>Go to a signal</source>
        <translation>转到某个信号</translation>
    </message>
    <message>
        <source>Write the signal (network inputs)</source>
        <translation>写入信号（网络输入）</translation>
    </message>
    <message>
        <source>On the tab Watch: watch the signal no longer</source>
        <translation>在“关注”选项卡上：取消关注该信号</translation>
    </message>
    <message>
        <source>Go to a register</source>
        <translation>转到某个寄存器</translation>
    </message>
    <message>
        <source>Open the editor; in it: stage the value</source>
        <translation>打开编辑器；在编辑器中：暂存该值</translation>
    </message>
    <message>
        <source>Discard the staged value</source>
        <translation>放弃暂存的值</translation>
    </message>
    <message>
        <source>Copy the chosen rows</source>
        <translation>复制所选的行</translation>
    </message>
    <message>
        <source>Paste cells: they are staged after a preview</source>
        <translation>粘贴单元格：预览后暂存</translation>
    </message>
    <message>
        <source>Go to a variable</source>
        <translation>转到某个变量</translation>
    </message>
    <message>
        <source>Held on a jog button: steps, if keyboard jog was switched on</source>
        <translation>在点动按钮上按住：逐步移动（须已开启键盘点动）</translation>
    </message>
    <message>
        <source>In the sheet of the move, after typing its words: move</source>
        <translation>在移动对话框中，输入指定文字后：移动</translation>
    </message>
    <message>
        <source>In the plot: move the cursor</source>
        <translation>在曲线图中：移动光标</translation>
    </message>
    <message>
        <source>In the plot: cursor to the oldest or newest time in view</source>
        <translation>在曲线图中：将光标移到视图中最早或最新的时间</translation>
    </message>
    <message>
        <source>In the plot: take the cursor away</source>
        <translation>在曲线图中：移除光标</translation>
    </message>
    <message>
        <source>In the list of signals: remove it from the trend</source>
        <translation>在信号列表中：从趋势中移除该信号</translation>
    </message>
    <message>
        <source>In the start sheet, after typing its words: start</source>
        <translation>在启动对话框中，输入指定文字后：启动</translation>
    </message>
    <message>
        <source>Copy the chosen rows of the list with the focus</source>
        <translation>复制焦点所在列表中所选的行</translation>
    </message>
    <message>
        <source>“Job” is what the controller names: at rest the job that a start would begin, else the one that runs. “Run” says which.</source>
        <translation>“程序”是控制器给出的程序：静止时为启动后将开始的程序，否则为正在运行的程序。由“运行”可知是哪一种。</translation>
    </message>
    <message>
        <source>All controllers side by side: those in alarm first, then those without a link and those that are held, then the others in a fixed order.</source>
        <translation>所有控制器并列显示：报警中的在最前，其次是没有链路的和 HOLD 中的，然后其余的按固定顺序排列。</translation>
    </message>
    <message>
        <source>A click opens a controller’s pages. The others stay connected and are read once a second.</source>
        <translation>单击可打开控制器的页面。其余控制器保持连接，每秒读取一次。</translation>
    </message>
    <message>
        <source>HOLD ALL orders a software hold at every controller that is not off, asks nothing, and says of each whether it was confirmed. It is no emergency stop.</source>
        <translation>“全部 HOLD”向每台未处于 OFF 的控制器发送软件 HOLD，不作询问，并逐台显示是否得到确认。它不是急停。</translation>
    </message>
    <message>
        <source>Connect all and Back up all only read. Nothing else goes to several controllers at once.</source>
        <translation>“全部连接”和“全部备份”仅进行读取。除此之外，不会同时向多台控制器发送任何内容。</translation>
    </message>
    <message>
        <source>Fleet</source>
        <translation>机群</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>逗号分隔值 (*.csv)</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
</context>
<context>
    <name>Readiness</name>
    <message>
        <source>A signal group and a B variable were asked for: %1.</source>
        <translation>已请求一个信号组和一个 B 变量：%1。</translation>
    </message>
    <message>
        <source>A signal group and a B variable are asked for while this sheet is open. Writing needs no REMOTE; whether data are protected cannot be read.</source>
        <translation>此对话框打开期间会请求一个信号组和一个 B 变量。写入不需要 REMOTE；数据是否受保护无法读取。</translation>
    </message>
    <message>
        <source>The software version, which tells the model, was not read yet.</source>
        <translation>尚未读取用于判断机型的软件版本。</translation>
    </message>
    <message>
        <source>The profile says %1, but %2 is the software of a %3.</source>
        <translation>配置中为 %1，但 %2 是 %3 的软件。</translation>
    </message>
    <message>
        <source>The software %1 does not tell the model. The ranges are those of the profile&apos;s %2.</source>
        <translation>从软件 %1 无法得知机型。所用范围为配置中 %2 的范围。</translation>
    </message>
    <message>
        <source>The software %1 is that of a %2. Its ranges come from a table, not from the controller.</source>
        <translation>软件 %1 是 %2 的软件。其范围来自对照表，而不是来自控制器。</translation>
    </message>
    <message>
        <source>The last HOLD was refused: %1.</source>
        <translation>上次 HOLD 被拒绝：%1。</translation>
    </message>
    <message>
        <source>The last HOLD was confirmed by the status. It is a software hold, no emergency stop.</source>
        <translation>上次 HOLD 已由状态确认。这是软件 HOLD，不是急停。</translation>
    </message>
    <message>
        <source>The last HOLD was sent, and the status did not confirm it.</source>
        <translation>上次 HOLD 已发送，但状态未予确认。</translation>
    </message>
    <message>
        <source>It needs neither REMOTE nor an access level, and was not tried. It is a software hold, no emergency stop.</source>
        <translation>既不需要 REMOTE，也不需要访问级别；尚未尝试过。这是软件 HOLD，不是急停。</translation>
    </message>
    <message>
        <source>A list of jobs was asked for at port %1: %2.</source>
        <translation>已向端口 %1 请求程序列表：%2。</translation>
    </message>
    <message>
        <source>A list of jobs is asked for at port %1.</source>
        <translation>将向端口 %1 请求程序列表。</translation>
    </message>
    <message>
        <source>Port %1 lists the jobs. Sending and deleting files need REMOTE.</source>
        <translation>端口 %1 可列出程序。发送和删除文件需要 REMOTE。</translation>
    </message>
    <message>
        <source>This simulation has B000 at number %1 on the network.</source>
        <translation>此仿真中，网络编号 %1 为 B000。</translation>
    </message>
    <message>
        <source>The software version, with which it was compared, was not read yet.</source>
        <translation>尚未读取软件版本，因此无法与比较编号时的软件版本核对。</translation>
    </message>
    <message>
        <source>It was compared with software %1, but %2 runs now: variables are not written before it is compared again.</source>
        <translation>比较时的软件为 %1，但现在运行的是 %2：重新比较之前不写入变量。</translation>
    </message>
    <message>
        <source>Whether B000 is number 0 or 1 on the network is unverified; variables are not written.</source>
        <translation>B000 的网络编号是 0 还是 1 未经验证；不写入变量。</translation>
    </message>
    <message>
        <source>Compared with the pendant on %1: number 0 on the network is B000.</source>
        <translation>已于 %1 与示教编程器比较：网络编号 0 为 B000。</translation>
    </message>
    <message>
        <source>Compared with the pendant on %1, shifted: number 1 on the network is B000.</source>
        <translation>已于 %1 与示教编程器比较，有偏移：网络编号 1 为 B000。</translation>
    </message>
    <message>
        <source>The controller does not answer any more. Reading resumes by itself.</source>
        <translation>控制器不再应答。将自动恢复读取。</translation>
    </message>
    <message>
        <source>The controller tells its status and system information. Reading needs no REMOTE.</source>
        <translation>控制器提供其状态和系统信息。读取不需要 REMOTE。</translation>
    </message>
    <message>
        <source>Orders are taken in command remote alone: start, select, reset, cycle, servo on.</source>
        <translation>仅在启用命令远程时接受命令：启动、选择、复位、循环、接通伺服。</translation>
    </message>
    <message>
        <source>It needs REMOTE, and that no job runs.</source>
        <translation>需要 REMOTE，且没有程序在运行。</translation>
    </message>
    <message>
        <source>It needs PLAY, REMOTE, servo on and a job, and nothing that holds the robot.</source>
        <translation>需要 PLAY、REMOTE、伺服已接通和已选择程序，且没有任何来源使机器人保持 HOLD。</translation>
    </message>
    <message>
        <source>It needs PLAY and REMOTE. Servo off can always be ordered from here; whether it is taken without REMOTE is up to the controller.</source>
        <translation>需要 PLAY 和 REMOTE。断开伺服的命令始终可以从此处发送；没有 REMOTE 时是否接受由控制器决定。</translation>
    </message>
    <message>
        <source>They need what a start needs, but for the job, and a model that knows them.</source>
        <translation>除程序外，所需条件与启动相同，并且机型须支持这些命令。</translation>
    </message>
    <message>
        <source>Sending a file that exists there needs REMOTE and two parameters.</source>
        <translation>发送控制器上已存在的文件需要 REMOTE 和两个参数。</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>I/O and variables</source>
        <translation>I/O 和变量</translation>
    </message>
    <message>
        <source>Ranges of the model</source>
        <translation>机型的范围</translation>
    </message>
    <message>
        <source>Orders (REMOTE)</source>
        <translation>命令（REMOTE）</translation>
    </message>
    <message>
        <source>Selecting a job</source>
        <translation>选择程序</translation>
    </message>
    <message>
        <source>Starting a job</source>
        <translation>启动程序</translation>
    </message>
    <message>
        <source>Switching servo on</source>
        <translation>接通伺服</translation>
    </message>
    <message>
        <source>Jog and move</source>
        <translation>点动和移动</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD（软件）</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Replacing files</source>
        <translation>替换文件</translation>
    </message>
    <message>
        <source>Numbering of variables</source>
        <translation>变量编号</translation>
    </message>
    <message>
        <source>allowed</source>
        <translation>允许</translation>
    </message>
    <message>
        <source>not allowed</source>
        <translation>不允许</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>推定</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>尚未读取</translation>
    </message>
    <message>
        <source>In the way: %1.</source>
        <translation>阻碍因素：%1。</translation>
    </message>
    <message>
        <source>HSES does not tell whether this is so: %1.</source>
        <translation>HSES 不提供以下各项是否成立：%1。</translation>
    </message>
    <message>
        <source>What helps: %1.</source>
        <translation>解决办法：%1。</translation>
    </message>
    <message>
        <source>Diagnose… in the rail finds out at which step it fails.</source>
        <translation>导航栏中的“诊断…”可查明在哪一步失败。</translation>
    </message>
    <message>
        <source>Correct the model in the profile (Connect…).</source>
        <translation>请在配置中更正机型（“连接…”）。</translation>
    </message>
    <message>
        <source>Use the pendant.</source>
        <translation>请使用示教编程器。</translation>
    </message>
    <message>
        <source>Pendesk %1, readiness of %2 (%3), %4, %5</source>
        <translation>Pendesk %1，%2（%3）的就绪状态，%4，%5</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>subject, allowance, evidence</comment>
        <translation>%1：%2，%3</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source>The line does not have the numbers that belong there.</source>
        <translation>该行没有应有的数值。</translation>
    </message>
</context>
<context>
    <name>Shown</name>
    <message>
        <source>Not read yet.</source>
        <translation>尚未读取。</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>被拒绝：%1</translation>
    </message>
    <message>
        <source>Last seen %1</source>
        <translation>最后读取于 %1</translation>
    </message>
    <message>
        <source>not taught</source>
        <translation>未示教</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>HELD</source>
        <translation>HOLD 中</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>PENDANT</source>
        <translation>示教编程器</translation>
    </message>
    <message>
        <source>EXTERNAL</source>
        <translation>外部</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>TEACH</source>
        <translation>TEACH</translation>
    </message>
    <message>
        <source>PLAY</source>
        <translation>PLAY</translation>
    </message>
    <message>
        <source>NO MODE</source>
        <translation>无模式</translation>
    </message>
    <message>
        <source>REMOTE %1</source>
        <translation>REMOTE %1</translation>
    </message>
    <message>
        <source>STEP</source>
        <translation>单步</translation>
    </message>
    <message>
        <source>1 CYCLE</source>
        <translation>单循环</translation>
    </message>
    <message>
        <source>CONTINUOUS</source>
        <translation>连续</translation>
    </message>
    <message>
        <source>NO CYCLE</source>
        <translation>无循环</translation>
    </message>
    <message>
        <source>RUNNING</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>ON</source>
        <translation>ON</translation>
    </message>
    <message>
        <source>OFF</source>
        <translation>OFF</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>ALARM</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>held</source>
        <translation>HOLD 中</translation>
    </message>
    <message>
        <source>contradictory</source>
        <translation>相互矛盾</translation>
    </message>
    <message>
        <source>running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>line %1 · step %2 · %3</source>
        <translation>行 %1 · 程序点 %2 · %3</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>脉冲</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>HOLD asked for, %1 s…</source>
        <translation>已请求 HOLD，%1 s…</translation>
    </message>
    <message>
        <source>held by command</source>
        <translation>由命令保持 HOLD</translation>
    </message>
    <message>
        <source>held by the pendant</source>
        <translation>由示教编程器保持 HOLD</translation>
    </message>
    <message>
        <source>held externally</source>
        <translation>由外部保持 HOLD</translation>
    </message>
    <message>
        <source>HOLD refused</source>
        <translation>HOLD 被拒绝</translation>
    </message>
    <message>
        <source>HOLD not confirmed</source>
        <translation>HOLD 未得到确认</translation>
    </message>
    <message>
        <source>released</source>
        <translation>已解除</translation>
    </message>
    <message>
        <source>software hold · Pause key</source>
        <translation>软件 HOLD · Pause 键</translation>
    </message>
</context>
<context>
    <name>cell::Sentences</name>
    <message>
        <source>%1 changed</source>
        <translation>%1 已改变</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>%1: gone.</source>
        <translation>%1：已消失。</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) differ, from line %1 on.</source>
        <translation>
            <numerusform>从第 %1 行起，有 %n 行不同。</numerusform>
        </translation>
    </message>
    <message>
        <source>The newer file is empty; what stood in it is not known to be deleted.</source>
        <translation>较新的文件为空；原有内容是否已被删除未知。</translation>
    </message>
    <message>
        <source>The older file is empty.</source>
        <translation>较旧的文件为空。</translation>
    </message>
    <message numerus="yes">
        <source>And %n more difference(s).</source>
        <translation>
            <numerusform>另有 %n 处差异。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 bytes; the content differs.</source>
        <translation>%1 字节；内容不同。</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>moved %1 mm (%2)</source>
        <translation>已移动 %1 mm (%2)</translation>
    </message>
    <message>
        <source>turned %1 deg (%2)</source>
        <translation>已旋转 %1 deg (%2)</translation>
    </message>
    <message numerus="yes">
        <source>Used by %n job(s).</source>
        <translation>
            <numerusform>被 %n 个程序使用。</numerusform>
        </translation>
    </message>
    <message>
        <source>could not be read in one of the files</source>
        <translation>在其中一个文件中无法读取</translation>
    </message>
    <message>
        <source>name %1</source>
        <translation>名称 %1</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>控制点 %1</translation>
    </message>
    <message>
        <source>weight %1 kg</source>
        <translation>重量 %1 kg</translation>
    </message>
    <message>
        <source>centre of gravity %1 mm</source>
        <translation>重心 %1 mm</translation>
    </message>
    <message>
        <source>inertia %1 kgm²</source>
        <translation>惯量 %1 kgm²</translation>
    </message>
    <message>
        <source>kind of entry %1</source>
        <translation>输入方式 %1</translation>
    </message>
    <message>
        <source>%1 is new.</source>
        <translation>%1 为新增。</translation>
    </message>
    <message>
        <source>%1 is gone.</source>
        <translation>%1 已消失。</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>工具 %1</translation>
    </message>
    <message>
        <source>User frame %1</source>
        <translation>用户坐标 %1</translation>
    </message>
    <message>
        <source>where it lies could not be read in one of the files</source>
        <translation>在其中一个文件中无法读取其位置</translation>
    </message>
    <message>
        <source>taught with tool %1</source>
        <translation>以工具 %1 示教</translation>
    </message>
    <message>
        <source>taught at other points</source>
        <translation>以其他点示教</translation>
    </message>
    <message>
        <source>Area %1</source>
        <translation>干涉区 %1</translation>
    </message>
    <message>
        <source>set</source>
        <translation>已设定</translation>
    </message>
    <message>
        <source>no longer set</source>
        <translation>不再设定</translation>
    </message>
    <message>
        <source>upper %1 %2 mm</source>
        <translation>上限 %1 %2 mm</translation>
    </message>
    <message>
        <source>lower %1 %2 mm</source>
        <translation>下限 %1 %2 mm</translation>
    </message>
    <message>
        <source>other coordinates or another group</source>
        <translation>坐标或控制轴组不同</translation>
    </message>
    <message>
        <source>Collision detection, set %1, group %2</source>
        <translation>碰撞检测，条件 %1，组 %2</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>已关闭</translation>
    </message>
    <message>
        <source>switched on</source>
        <translation>已开启</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>等级 %1</translation>
    </message>
    <message>
        <source>robot %1 limit %2 %3 %4 deg</source>
        <translation>机器人 %1 限值 %2 %3 %4 deg</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>已改变</translation>
    </message>
    <message>
        <source>meaning not known</source>
        <translation>含义未知</translation>
    </message>
    <message>
        <source>Section %1 has %2 values.</source>
        <translation>段 %1 有 %2 个值。</translation>
    </message>
    <message>
        <source>System part</source>
        <translation>系统部分</translation>
    </message>
    <message>
        <source>User part</source>
        <translation>用户部分</translation>
    </message>
    <message>
        <source>decides %1</source>
        <translation>决定 %1</translation>
    </message>
    <message>
        <source>%1, instruction %2: %3</source>
        <translation>%1，命令 %2：%3</translation>
    </message>
    <message>
        <source>%1 became %2</source>
        <translation>%1 变为 %2</translation>
    </message>
    <message>
        <source>%1 is new</source>
        <translation>%1 为新增</translation>
    </message>
    <message>
        <source>%1 is gone</source>
        <translation>%1 已消失</translation>
    </message>
    <message>
        <source>Now also written: %1.</source>
        <translation>现在也写入：%1。</translation>
    </message>
    <message>
        <source>No longer written: %1.</source>
        <translation>不再写入：%1。</translation>
    </message>
    <message>
        <source>The control group %1 is another one.</source>
        <translation>控制轴组 %1 已变为另一个。</translation>
    </message>
    <message>
        <source>Another number of control groups.</source>
        <translation>控制轴组的数量不同。</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>The hours of control power went back by %1: another controller, or its memory was cleared.</source>
        <translation>控制电源的通电时间减少了 %1：可能是另一台控制器，或其存储器已被清除。</translation>
    </message>
    <message>
        <source>%1 powered in between.</source>
        <translation>其间通电 %1。</translation>
    </message>
    <message>
        <source>Section %1 is new.</source>
        <translation>段 %1 为新增。</translation>
    </message>
    <message>
        <source>Section %1 is not in the newer file.</source>
        <translation>较新的文件中没有段 %1。</translation>
    </message>
    <message>
        <source>Presets of timers and counters changed.</source>
        <translation>定时器和计数器的预设值已改变。</translation>
    </message>
    <message>
        <source>Home position of %1 axis %2 recalibrated (%3): taught points may be off.</source>
        <translation>%1 轴 %2 的原点位置已重新校准 (%3)：已示教的点可能有偏差。</translation>
    </message>
    <message>
        <source>Position of %1 axis %2: %3 pulses.</source>
        <translation>%1 轴 %2 的位置：%3 脉冲。</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source> Command remote select: HSES control is permitted.</source>
        <translation> 命令远程选择：允许 HSES 控制。</translation>
    </message>
    <message>
        <source> Command remote select: HSES control will be refused.</source>
        <translation> 命令远程选择：HSES 控制将被拒绝。</translation>
    </message>
    <message>
        <source>Pseudo input %1 switched %2.</source>
        <translation>伪输入 %1 切换为 %2。</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>软件</translation>
    </message>
    <message>
        <source>Parameter version</source>
        <translation>参数版本</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Applications</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>基板</translation>
    </message>
    <message numerus="yes">
        <source>%n new entry(ies).</source>
        <translation>
            <numerusform>%n 个新条目。</numerusform>
        </translation>
    </message>
    <message>
        <source>The log rolled over: edits in between are not known.</source>
        <translation>日志已循环覆盖：其间的编辑未知。</translation>
    </message>
    <message numerus="yes">
        <source>%n new alarm(s): %1.</source>
        <translation>
            <numerusform>%n 个新报警：%1。</numerusform>
        </translation>
    </message>
    <message>
        <source>coordinates %1</source>
        <translation>坐标 %1</translation>
    </message>
    <message>
        <source>tool %1</source>
        <translation>工具 %1</translation>
    </message>
    <message>
        <source>user frame %1</source>
        <translation>用户坐标 %1</translation>
    </message>
    <message>
        <source>form of the arm</source>
        <translation>手臂形态</translation>
    </message>
    <message>
        <source>now set (%1)</source>
        <translation>现已设定 (%1)</translation>
    </message>
    <message>
        <source>Number of variables %1</source>
        <translation>变量 %1 的数量</translation>
    </message>
    <message>
        <source>%1 lost its name “%2”.</source>
        <translation>%1 失去了名称“%2”。</translation>
    </message>
    <message>
        <source>%1 is now named “%2”.</source>
        <translation>%1 现在的名称为“%2”。</translation>
    </message>
    <message>
        <source>%1 “%2” is now named “%3”.</source>
        <translation>%1“%2”现在的名称为“%3”。</translation>
    </message>
    <message>
        <source>written</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>read</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>waited for</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>called</source>
        <translation>调用</translation>
    </message>
    <message>
        <source>jumped to</source>
        <translation>跳转到</translation>
    </message>
    <message>
        <source>started</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>named</source>
        <translation>命名</translation>
    </message>
    <message>
        <source>may be %1</source>
        <translation>可能%1</translation>
    </message>
    <message>
        <source>%1 line %2</source>
        <translation>%1 第 %2 行</translation>
    </message>
    <message>
        <source>%1 is called, and no file has it: %2.</source>
        <translation>%1 被调用，但没有任何文件包含它：%2。</translation>
    </message>
    <message>
        <source>%1 is written in several places: %2.</source>
        <translation>%1 在多处被写入：%2。</translation>
    </message>
    <message>
        <source>%1 is read and never written in the files: %2.</source>
        <translation>%1 被读取，但文件中从未写入：%2。</translation>
    </message>
    <message>
        <source>%1 has several names: %2.</source>
        <translation>%1 有多个名称：%2。</translation>
    </message>
    <message>
        <source>%1 is used and its data were not entered: %2.</source>
        <translation>%1 被使用，但其数据未输入：%2。</translation>
    </message>
    <message>
        <source>%1 is named by no other job and no macro.</source>
        <translation>没有其他程序或宏引用 %1。</translation>
    </message>
</context>
<context>
    <name>cellfiles::Sentences</name>
    <message>
        <source>values</source>
        <translation>值</translation>
    </message>
    <message>
        <source>block</source>
        <translation>块</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>条目</translation>
    </message>
    <message>
        <source>value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>job</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>collision detection</source>
        <translation>碰撞检测</translation>
    </message>
    <message>
        <source>set</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>level</source>
        <translation>等级</translation>
    </message>
    <message>
        <source>reasons of stops</source>
        <translation>停止原因</translation>
    </message>
    <message>
        <source>number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>reasons</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>The line does not have the numbers that belong there.</source>
        <translation>该行没有应有的数值。</translation>
    </message>
    <message>
        <source>The block has no number.</source>
        <translation>该块没有编号。</translation>
    </message>
    <message>
        <source>Tool %1 is not complete.</source>
        <translation>工具 %1 不完整。</translation>
    </message>
    <message>
        <source>User frame %1 is not complete: where it lies is unknown.</source>
        <translation>用户坐标 %1 不完整：其位置未知。</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>User frames</source>
        <translation>用户坐标</translation>
    </message>
    <message>
        <source>Interference areas</source>
        <translation>干涉区</translation>
    </message>
    <message>
        <source>Collision detection</source>
        <translation>碰撞检测</translation>
    </message>
    <message>
        <source>Weaving conditions</source>
        <translation>摆焊条件</translation>
    </message>
    <message>
        <source>Arc start conditions</source>
        <translation>引弧条件</translation>
    </message>
    <message>
        <source>Arc end conditions</source>
        <translation>熄弧条件</translation>
    </message>
    <message>
        <source>Arc auxiliary conditions</source>
        <translation>弧焊辅助条件</translation>
    </message>
    <message>
        <source>Welders</source>
        <translation>焊机</translation>
    </message>
    <message>
        <source>Cutting shapes</source>
        <translation>切割形状</translation>
    </message>
    <message>
        <source>Maintenance conditions</source>
        <translation>维护条件</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Names of variables</source>
        <translation>变量名称</translation>
    </message>
    <message>
        <source>Names of signals</source>
        <translation>信号名称</translation>
    </message>
    <message>
        <source>Names of external signals</source>
        <translation>外部信号名称</translation>
    </message>
    <message>
        <source>Names of registers</source>
        <translation>寄存器名称</translation>
    </message>
    <message>
        <source>Names of timers</source>
        <translation>定时器名称</translation>
    </message>
    <message>
        <source>Timers</source>
        <translation>定时器</translation>
    </message>
    <message>
        <source>Timer settings</source>
        <translation>定时器设定</translation>
    </message>
    <message>
        <source>Watch list</source>
        <translation>关注列表</translation>
    </message>
    <message>
        <source>Groups of signals</source>
        <translation>信号组</translation>
    </message>
    <message>
        <source>User words</source>
        <translation>用户用语</translation>
    </message>
    <message>
        <source>User menus</source>
        <translation>用户菜单</translation>
    </message>
    <message>
        <source>Names of flags</source>
        <translation>标志名称</translation>
    </message>
    <message>
        <source>Key functions</source>
        <translation>键功能</translation>
    </message>
    <message>
        <source>Interface panels</source>
        <translation>接口面板</translation>
    </message>
    <message>
        <source>Macro commands</source>
        <translation>宏命令</translation>
    </message>
    <message>
        <source>Ladder</source>
        <translation>梯形图</translation>
    </message>
    <message>
        <source>Pseudo inputs</source>
        <translation>伪输入</translation>
    </message>
    <message>
        <source>I/O boards</source>
        <translation>I/O 基板</translation>
    </message>
    <message>
        <source>I/O axes</source>
        <translation>I/O 轴</translation>
    </message>
    <message>
        <source>EtherNet/IP</source>
        <translation>EtherNet/IP</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>Address translation</source>
        <translation>地址转换</translation>
    </message>
    <message>
        <source>Remote users</source>
        <translation>远程用户</translation>
    </message>
    <message>
        <source>Home positions of the encoders</source>
        <translation>编码器的原点位置</translation>
    </message>
    <message>
        <source>Second home position</source>
        <translation>第二原点位置</translation>
    </message>
    <message>
        <source>Operation origin</source>
        <translation>作业原点</translation>
    </message>
    <message>
        <source>Robot calibration</source>
        <translation>机器人校准</translation>
    </message>
    <message>
        <source>Tool interference</source>
        <translation>工具干涉</translation>
    </message>
    <message>
        <source>Arrangement of robots</source>
        <translation>机器人布置</translation>
    </message>
    <message>
        <source>Approach buzzer</source>
        <translation>接近蜂鸣器</translation>
    </message>
    <message>
        <source>Servo assistance</source>
        <translation>伺服辅助</translation>
    </message>
    <message>
        <source>Safety logic</source>
        <translation>安全逻辑</translation>
    </message>
    <message>
        <source>Range limits</source>
        <translation>范围限制</translation>
    </message>
    <message>
        <source>Axis speed monitor</source>
        <translation>轴速度监视</translation>
    </message>
    <message>
        <source>Speed limits</source>
        <translation>速度限制</translation>
    </message>
    <message>
        <source>Tool angle monitor</source>
        <translation>工具角度监视</translation>
    </message>
    <message>
        <source>Check sums of safety data</source>
        <translation>安全数据的校验和</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>System</source>
        <translation>系统</translation>
    </message>
    <message>
        <source>System, options and change dates</source>
        <translation>系统、选项和更改日期</translation>
    </message>
    <message>
        <source>Operation log</source>
        <translation>操作日志</translation>
    </message>
    <message>
        <source>Alarm history</source>
        <translation>报警履历</translation>
    </message>
    <message>
        <source>Message history</source>
        <translation>信息履历</translation>
    </message>
    <message>
        <source>Fast events</source>
        <translation>高速事件</translation>
    </message>
    <message>
        <source>Reasons of stops</source>
        <translation>停止原因</translation>
    </message>
    <message>
        <source>Maintenance counters</source>
        <translation>维护计数器</translation>
    </message>
    <message>
        <source>Torque counters</source>
        <translation>转矩计数器</translation>
    </message>
    <message>
        <source>Encoder heat</source>
        <translation>编码器发热</translation>
    </message>
    <message>
        <source>Step diagnosis</source>
        <translation>程序点诊断</translation>
    </message>
    <message>
        <source>Job monitor</source>
        <translation>程序监视</translation>
    </message>
    <message>
        <source>Robot monitor</source>
        <translation>机器人监视</translation>
    </message>
    <message>
        <source>Servo monitor</source>
        <translation>伺服监视</translation>
    </message>
    <message>
        <source>Regeneration unit</source>
        <translation>再生单元</translation>
    </message>
    <message>
        <source>Memory image</source>
        <translation>内存映像</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Unknown file</source>
        <translation>未知文件</translation>
    </message>
    <message>
        <source>The file ends before the values of %1.</source>
        <translation>文件在 %1 的值之前结束。</translation>
    </message>
    <message>
        <source>The control groups of this line could not be read.</source>
        <translation>无法读取此行的控制轴组。</translation>
    </message>
    <message>
        <source>This section is not understood.</source>
        <translation>无法识别此段。</translation>
    </message>
    <message>
        <source>“%1” is not understood.</source>
        <translation>无法识别“%1”。</translation>
    </message>
    <message>
        <source>The record in front of this date is not understood.</source>
        <translation>无法识别此日期前的记录。</translation>
    </message>
    <message>
        <source>The record that begins here is not complete.</source>
        <translation>从此处开始的记录不完整。</translation>
    </message>
    <message>
        <source>The section %1 announces %2 records and holds %3.</source>
        <translation>段 %1 声明有 %2 条记录，实际有 %3 条。</translation>
    </message>
    <message>
        <source>The entry is numbered %1 and is number %2 by its place.</source>
        <translation>该条目的编号为 %1，而按其位置应为 %2。</translation>
    </message>
    <message>
        <source>The entry is not complete.</source>
        <translation>该条目不完整。</translation>
    </message>
    <message>
        <source>The number of the macro cannot be read.</source>
        <translation>无法读取宏的编号。</translation>
    </message>
    <message>
        <source>The line holds NUL bytes.</source>
        <translation>该行含有 NUL 字节。</translation>
    </message>
    <message>
        <source>Lines end in LF alone. A pendant may take such a file for empty: convert it to CR LF before it is loaded.</source>
        <translation>行尾只有 LF。示教编程器可能将此类文件视为空文件：加载前请转换为 CR LF。</translation>
    </message>
    <message>
        <source>The file ends within a line: it may be cut.</source>
        <translation>文件在行中间结束：可能被截断。</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>文件为空。</translation>
    </message>
    <message>
        <source>The file is too long to be read.</source>
        <translation>文件过长，无法读取。</translation>
    </message>
    <message>
        <source>%1 has no section “%2”; the rows below it are not understood.</source>
        <translation>%1 没有段“%2”；无法识别其下的行。</translation>
    </message>
    <message>
        <source>The row has %1 instead of 10 values; the missing ones of %2 are unknown.</source>
        <translation>该行有 %1 个值，而不是 10 个；%2 缺少的值未知。</translation>
    </message>
    <message>
        <source>%1 is no number of 32 bits.</source>
        <translation>%1 不是 32 位数。</translation>
    </message>
    <message>
        <source>data transmission; 2 is over the network</source>
        <translation>数据传输；2 表示通过网络</translation>
    </message>
    <message>
        <source>numbering of variables for network clients; 1: by their number, 0: by their number plus one</source>
        <translation>网络客户端的变量编号；1：按变量编号，0：按变量编号加一</translation>
    </message>
    <message>
        <source>1 permits network clients to overwrite files</source>
        <translation>1 允许网络客户端覆盖文件</translation>
    </message>
    <message>
        <source>serial transmission: data bits, parity, stop, speed, timers</source>
        <translation>串行传输：数据位、奇偶校验、停止位、速度、定时器</translation>
    </message>
    <message>
        <source>3 permits overwriting when loading from USB</source>
        <translation>3 允许从 USB 加载时覆盖</translation>
    </message>
    <message>
        <source>address and mask of the controller</source>
        <translation>控制器的地址和掩码</translation>
    </message>
    <message>
        <source>1 permits FTP</source>
        <translation>1 允许 FTP</translation>
    </message>
    <message>
        <source>1 permits network clients to overwrite files; the meaning of 2 is not known</source>
        <translation>1 允许网络客户端覆盖文件；2 的含义未知</translation>
    </message>
    <message>
        <source>addresses and masks</source>
        <translation>地址和掩码</translation>
    </message>
    <message>
        <source>0 permits selecting jobs in remote and play</source>
        <translation>0 允许在 REMOTE 和 PLAY 时选择程序</translation>
    </message>
    <message>
        <source>pendant operation in remote; 63 permits starts and edits</source>
        <translation>REMOTE 时的示教编程器操作；63 允许启动和编辑</translation>
    </message>
    <message>
        <source>alias function; 0 permits loading own names</source>
        <translation>别名功能；0 允许加载自定义名称</translation>
    </message>
    <message>
        <source>drivers that start motion need 0</source>
        <translation>启动动作的驱动程序需要 0</translation>
    </message>
    <message>
        <source>MotoPlus and telnet settings</source>
        <translation>MotoPlus 和 telnet 设置</translation>
    </message>
    <message>
        <source>number of variables of each kind</source>
        <translation>每种变量的数量</translation>
    </message>
    <message>
        <source>control groups and their axes</source>
        <translation>控制轴组及其轴</translation>
    </message>
    <message>
        <source>pseudo input signals</source>
        <translation>伪输入信号</translation>
    </message>
    <message>
        <source>The name “%1” holds bytes that the text encoding does not know.</source>
        <translation>名称“%1”含有文本编码中没有的字节。</translation>
    </message>
    <message>
        <source>The row has more than four names.</source>
        <translation>该行的名称多于四个。</translation>
    </message>
    <message>
        <source>There are more names than signals.</source>
        <translation>名称多于信号。</translation>
    </message>
    <message>
        <source>The row is not a number, two flags and a name.</source>
        <translation>该行不是由一个编号、两个标志和一个名称组成。</translation>
    </message>
    <message numerus="yes">
        <source>%1 is beyond the %n variable(s) that the file announces.</source>
        <translation>
            <numerusform>%1 超出文件声明的 %n 个变量。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was named “%2” before; which name the pendant shows is not known.</source>
        <translation>%1 之前已命名为“%2”；示教编程器显示哪个名称未知。</translation>
    </message>
    <message>
        <source>The line stands in a section that names no signals.</source>
        <translation>该行所在的段不是信号名称。</translation>
    </message>
    <message>
        <source>The line does not announce a number for each of the eight kinds.</source>
        <translation>该行没有为八种变量各声明一个数量。</translation>
    </message>
    <message>
        <source>The hours could not be read.</source>
        <translation>无法读取时间。</translation>
    </message>
    <message>
        <source>The file does not say the version of the system software.</source>
        <translation>文件未写明系统软件的版本。</translation>
    </message>
    <message>
        <source>system</source>
        <translation>系统</translation>
    </message>
    <message>
        <source>model</source>
        <translation>机型</translation>
    </message>
    <message>
        <source>software</source>
        <translation>软件</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>application</source>
        <translation>用途</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n axis/axes</source>
        <translation>
            <numerusform>%1，%n 轴</numerusform>
        </translation>
    </message>
    <message>
        <source>boards</source>
        <translation>基板</translation>
    </message>
    <message>
        <source>board</source>
        <translation>基板</translation>
    </message>
    <message>
        <source>hours</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>counter</source>
        <translation>计数器</translation>
    </message>
    <message>
        <source>options</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>含义</translation>
    </message>
    <message>
        <source>ladder</source>
        <translation>梯形图</translation>
    </message>
    <message>
        <source>part</source>
        <translation>部分</translation>
    </message>
    <message>
        <source>instruction</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>operation log</source>
        <translation>操作日志</translation>
    </message>
    <message>
        <source>event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>alarm history</source>
        <translation>报警履历</translation>
    </message>
    <message>
        <source>class</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>详情</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>未输入</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>measured load</source>
        <translation>实测负载</translation>
    </message>
    <message>
        <source>base coordinates</source>
        <translation>基座坐标</translation>
    </message>
    <message>
        <source>robot coordinates</source>
        <translation>机器人坐标</translation>
    </message>
    <message>
        <source>user frame %1</source>
        <translation>用户坐标 %1</translation>
    </message>
    <message>
        <source>unused</source>
        <translation>未使用</translation>
    </message>
    <message>
        <source>tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>weight kg</source>
        <translation>重量 kg</translation>
    </message>
    <message>
        <source>entered</source>
        <translation>输入方式</translation>
    </message>
    <message>
        <source>user frames</source>
        <translation>用户坐标</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>interference areas</source>
        <translation>干涉区</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>坐标</translation>
    </message>
    <message>
        <source>lower X mm</source>
        <translation>下限 X mm</translation>
    </message>
    <message>
        <source>upper X mm</source>
        <translation>上限 X mm</translation>
    </message>
    <message>
        <source>lower Y mm</source>
        <translation>下限 Y mm</translation>
    </message>
    <message>
        <source>upper Y mm</source>
        <translation>上限 Y mm</translation>
    </message>
    <message>
        <source>lower Z mm</source>
        <translation>下限 Z mm</translation>
    </message>
    <message>
        <source>upper Z mm</source>
        <translation>上限 Z mm</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>未设定</translation>
    </message>
    <message>
        <source>variables</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>user frame</source>
        <translation>用户坐标</translation>
    </message>
    <message>
        <source>form</source>
        <translation>形态</translation>
    </message>
    <message>
        <source>names</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>register</source>
        <translation>寄存器</translation>
    </message>
    <message>
        <source>timer</source>
        <translation>定时器</translation>
    </message>
    <message>
        <source>home positions, pulses</source>
        <translation>原点位置，脉冲</translation>
    </message>
    <message>
        <source>pseudo inputs</source>
        <translation>伪输入</translation>
    </message>
    <message>
        <source>byte</source>
        <translation>字节</translation>
    </message>
    <message>
        <source>bits</source>
        <translation>位</translation>
    </message>
    <message>
        <source>The value of %1 could not be read.</source>
        <translation>无法读取 %1 的值。</translation>
    </message>
    <message>
        <source>The file announces %1 variables %2 and has %3; the others are not known.</source>
        <translation>文件声明有 %1 个变量 %2，实际有 %3 个；其余的未知。</translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>脉冲</translation>
    </message>
    <message>
        <source>tool coordinates</source>
        <translation>工具坐标</translation>
    </message>
    <message>
        <source>user coordinates</source>
        <translation>用户坐标</translation>
    </message>
    <message>
        <source>master tool coordinates</source>
        <translation>主工具坐标</translation>
    </message>
</context>
<context>
    <name>dialogs::AccessSettingsDialog</name>
    <message>
        <source>Passcode and idle time</source>
        <translation>密码和空闲时间</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Back to Monitor after</source>
        <translation>返回“监视”前的时间</translation>
    </message>
    <message>
        <source>New passcode</source>
        <translation>新密码</translation>
    </message>
    <message>
        <source>The same again</source>
        <translation>再次输入</translation>
    </message>
    <message>
        <source>Leave both empty for no passcode.</source>
        <translation>两处都留空表示不设密码。</translation>
    </message>
    <message>
        <source>The two are not the same.</source>
        <translation>两次输入不一致。</translation>
    </message>
</context>
<context>
    <name>dialogs::AppearanceDialog</name>
    <message>
        <source>As the desktop</source>
        <translation>按桌面设置</translation>
    </message>
    <message>
        <source>Language and look</source>
        <translation>语言和外观</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>L&amp;ook</source>
        <translation>外观(&amp;O)</translation>
    </message>
    <message>
        <source>Words of the robot and text from the controller stay as they are on the pendant.</source>
        <translation>机器人的用语和来自控制器的文本与示教编程器上保持一致。</translation>
    </message>
</context>
<context>
    <name>dialogs::ApplyDialog</name>
    <message>
        <source>Variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Old value</source>
        <translation>旧值</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>新值</translation>
    </message>
    <message>
        <source>Apply — %1</source>
        <translation>应用 — %1</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>将写入的内容</translation>
    </message>
    <message numerus="yes">
        <source>Write %n value(s)</source>
        <translation>
            <numerusform>写入 %n 个值</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Write %n value(s) to %1</source>
        <translation>
            <numerusform>将 %n 个值写入 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Each is written once and read back. What does not read back as it was written stays here and is marked.</source>
        <translation>每个值写入一次并回读。回读与写入不一致的值保留在此并加以标记。</translation>
    </message>
</context>
<context>
    <name>dialogs::CompareDialog</name>
    <message>
        <source>Both are the same, byte for byte.</source>
        <translation>两者逐字节相同。</translation>
    </message>
</context>
<context>
    <name>dialogs::ConnectionDialog</name>
    <message>
        <source>Duplicate</source>
        <translation>复制一份</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Connect to a controller</source>
        <translation>连接到控制器</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Known controllers</source>
        <translation>已知控制器</translation>
    </message>
    <message>
        <source>CONTROLLERS</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Connecting only reads. HOLD: Pause key.</source>
        <translation>连接仅进行读取。HOLD：Pause 键。</translation>
    </message>
    <message>
        <source>A motion limit must be a number above 0, and each side of the box must begin before it ends.</source>
        <translation>运动限值必须是大于 0 的数，且范围框每一边的起始值必须小于终止值。</translation>
    </message>
    <message>
        <source>There is another controller with the name “%1”.</source>
        <translation>已有另一台名为“%1”的控制器。</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>New controller</source>
        <translation>新控制器</translation>
    </message>
</context>
<context>
    <name>dialogs::DiagnosisDialog</name>
    <message>
        <source>Diagnosis — %1</source>
        <translation>诊断 — %1</translation>
    </message>
    <message>
        <source>Copy diagnosis</source>
        <translation>复制诊断结果</translation>
    </message>
    <message>
        <source>The diagnosis is not finished yet.</source>
        <translation>诊断尚未完成。</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>It only reads. HOLD works meanwhile: Pause key.</source>
        <translation>诊断仅进行读取。期间 HOLD 有效：Pause 键。</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>已复制</translation>
    </message>
</context>
<context>
    <name>dialogs::HelpDialog</name>
    <message>
        <source>Help — %1</source>
        <translation>帮助 — %1</translation>
    </message>
    <message>
        <source>Search in this help</source>
        <translation>在此帮助中搜索</translation>
    </message>
    <message>
        <source>Nothing here has these words.</source>
        <translation>此处没有包含这些词的内容。</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Keys of this page</source>
        <translation>此页面的按键</translation>
    </message>
    <message>
        <source>Keys everywhere</source>
        <translation>通用按键</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>菜单</translation>
    </message>
    <message>
        <source>Without a connection: connect to the controller on the filled button</source>
        <translation>未连接时：连接到填充色按钮上的控制器</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Live: read within its last three turns.</source>
        <translation>实时：在其最近三个读取周期内读取到。</translation>
    </message>
    <message>
        <source>Stale</source>
        <translation>已过时</translation>
    </message>
    <message>
        <source>Stale: read once, too long ago. The tool tip says when. It is not what the robot does now.</source>
        <translation>已过时：曾经读取，但时间已过久。工具提示显示读取时间。这不是机器人当前的状态。</translation>
    </message>
    <message>
        <source>Unknown: not read on this connection. It is never shown as 0.</source>
        <translation>未知：本次连接中未读取。绝不会显示为 0。</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>被拒绝</translation>
    </message>
    <message>
        <source>Refused: the controller does not tell it. The reason stands on the card or in the tool tip.</source>
        <translation>被拒绝：控制器不提供该内容。原因显示在卡片上或工具提示中。</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>A filled square: on, or 1.</source>
        <translation>实心方块：开，或 1。</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>A hollow square: off, or 0.</source>
        <translation>空心方块：关，或 0。</translation>
    </message>
    <message>
        <source>held</source>
        <translation>HOLD 中</translation>
    </message>
    <message>
        <source>An amber triangle: error, hold, something not allowed or to be looked at.</source>
        <translation>琥珀色三角：错误、HOLD、不允许的操作或需要查看的内容。</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>A red square: an alarm.</source>
        <translation>红色方块：报警。</translation>
    </message>
    <message>
        <source>What the signs mean</source>
        <translation>标记的含义</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>An amber ground in a table: typed and staged, not sent yet. A red one: it reads back differently from what was written.</source>
        <translation>表格中的琥珀色底色：已输入并暂存，尚未发送。红色底色：回读与写入不一致。</translation>
    </message>
</context>
<context>
    <name>dialogs::ImportDialog</name>
    <message>
        <source>Take over values — %1</source>
        <translation>采用值 — %1</translation>
    </message>
    <message numerus="yes">
        <source>Stage %n value(s)</source>
        <translation>
            <numerusform>暂存 %n 个值</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) would change</source>
        <translation>
            <numerusform>%n 个值将改变</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) are there already. Staging sends nothing to the controller.</source>
        <translation>
            <numerusform>%n 个值已一致。暂存不会向控制器发送任何内容。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) cannot be read, so nothing is taken over:</source>
        <translation>
            <numerusform>%n 行无法读取，因此未采用任何值：</numerusform>
        </translation>
    </message>
    <message>
        <source>Lines that cannot be read</source>
        <translation>无法读取的行</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Values that would change</source>
        <translation>将改变的值</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Old value</source>
        <translation>旧值</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>新值</translation>
    </message>
</context>
<context>
    <name>dialogs::IoWriteDialog</name>
    <message>
        <source>Write %1 — %2</source>
        <translation>写入 %1 — %2</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Will be</source>
        <translation>写入后</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>The eight signals #%1 to #%2 travel together: all of them are written as they stand here.</source>
        <translation>#%1 至 #%2 八个信号成组传送：全部按此处所示的状态写入。</translation>
    </message>
    <message>
        <source>The group is being read…</source>
        <translation>正在读取该组…</translation>
    </message>
    <message>
        <source>Written once, then read back.</source>
        <translation>写入一次，然后回读。</translation>
    </message>
    <message>
        <source>Another of the eight has changed meanwhile. Nothing was sent: look again.</source>
        <translation>期间八个信号中的另一个已改变。未发送任何内容：请重新查看。</translation>
    </message>
    <message>
        <source>Being written…</source>
        <translation>正在写入…</translation>
    </message>
    <message>
        <source>Written, and read back as it was written.</source>
        <translation>已写入，回读一致。</translation>
    </message>
    <message>
        <source>Accepted, but another value was read back: %1. Something else writes these signals.</source>
        <translation>已接受，但回读到其他值：%1。有其他来源在写入这些信号。</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>置为 ON</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>置为 OFF</translation>
    </message>
</context>
<context>
    <name>dialogs::JobEditor</name>
    <message>
        <source>Edit “%1”</source>
        <translation>编辑“%1”</translation>
    </message>
    <message>
        <source>Text of the file</source>
        <translation>文件内容</translation>
    </message>
    <message>
        <source>Compare and send…</source>
        <translation>比较并发送…</translation>
    </message>
    <message>
        <source>The controller&apos;s encoding lacks a character of this text.</source>
        <translation>控制器的编码中没有此文本中的某个字符。</translation>
    </message>
</context>
<context>
    <name>dialogs::LadderView</name>
    <message>
        <source>passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>未执行到</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Pendesk %1, diagnosis of %2 (%3)</source>
        <translation>Pendesk %1，%2（%3）的诊断</translation>
    </message>
</context>
<context>
    <name>dialogs::MotionForm</name>
    <message>
        <source>The tool point must stay in this box (base frame, mm)</source>
        <translation>工具控制点须保持在此范围框内（基座坐标，mm）</translation>
    </message>
    <message>
        <source>User and tool frames were checked on this robot</source>
        <translation>已在此机器人上确认用户坐标和工具坐标</translation>
    </message>
    <message>
        <source>Speed, mm/s</source>
        <translation>速度，mm/s</translation>
    </message>
    <message>
        <source>Rotation speed, °/s</source>
        <translation>回转速度，°/s</translation>
    </message>
    <message>
        <source>Joint speed, %</source>
        <translation>关节速度，%</translation>
    </message>
    <message>
        <source>Jog step, mm</source>
        <translation>点动步距，mm</translation>
    </message>
    <message>
        <source>Jog step, °</source>
        <translation>点动步距，°</translation>
    </message>
    <message>
        <source>Jog step, pulses</source>
        <translation>点动步距，脉冲</translation>
    </message>
    <message>
        <source>Descriptions disagree which code means the user and which the tool frame. Tick this only after a small move in both was watched at the robot.</source>
        <translation>关于哪个代码表示用户坐标、哪个表示工具坐标，各资料说法不一。只有在机器人旁观察过两种坐标下的小幅移动之后，才可勾选此项。</translation>
    </message>
    <message>
        <source>%1, as the program</source>
        <translation>%1，按软件默认</translation>
    </message>
    <message>
        <source>Least %1</source>
        <translation>%1 最小</translation>
    </message>
    <message>
        <source>Most %1</source>
        <translation>%1 最大</translation>
    </message>
    <message>
        <source>%1 from, to</source>
        <translation>%1 从、到</translation>
    </message>
</context>
<context>
    <name>dialogs::MoveSheet</name>
    <message>
        <source>%1 pulses</source>
        <translation>%1 脉冲</translation>
    </message>
    <message>
        <source>%1 mm · %2°</source>
        <translation>%1 mm · %2°</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Stop: HOLD</source>
        <translation>停止：HOLD</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Move at %1</source>
        <translation>以 %1 移动</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Control group</source>
        <translation>控制轴组</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>范围框</translation>
    </message>
    <message>
        <source>Stored points near the target</source>
        <translation>目标附近已存储的点</translation>
    </message>
    <message>
        <source>A long move, or one that nobody can measure: type %1</source>
        <translation>移动距离较长或无法测算：请输入 %1</translation>
    </message>
    <message>
        <source>With the keyboard: type %1, then F9</source>
        <translation>使用键盘：输入 %1，然后按 F9</translation>
    </message>
    <message>
        <source>HOLD stays on until it is released</source>
        <translation>HOLD 将保持有效，直到被解除</translation>
    </message>
    <message>
        <source>The robot will move</source>
        <translation>机器人将会移动</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>cannot be foretold in this frame</source>
        <translation>在此坐标系下无法预知</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>约 %1 s</translation>
    </message>
    <message>
        <source>not known: a percentage of joint speed</source>
        <translation>未知：以关节速度百分比表示</translation>
    </message>
    <message>
        <source>not known: the target is in pulses</source>
        <translation>未知：目标以脉冲表示</translation>
    </message>
    <message>
        <source>%1 mm and %2° between the ends; a joint move does not go straight</source>
        <translation>两端之间 %1 mm、%2°；关节移动不走直线</translation>
    </message>
    <message>
        <source>%1 mm straight, turning %2°</source>
        <translation>直线 %1 mm，转动 %2°</translation>
    </message>
    <message>
        <source>none is set for this controller</source>
        <translation>此控制器未设置</translation>
    </message>
    <message>
        <source>the whole way is inside</source>
        <translation>整个路径在范围框内</translation>
    </message>
    <message>
        <source>both ends are inside; the way between is not known</source>
        <translation>两端在范围框内；中间路径未知</translation>
    </message>
    <message>
        <source>%1, at most %2 %</source>
        <translation>%1，最大 %2 %</translation>
    </message>
    <message>
        <source>%1, at most %2 mm/s</source>
        <translation>%1，最大 %2 mm/s</translation>
    </message>
    <message>
        <source>%1, at most %2 °/s</source>
        <translation>%1，最大 %2 °/s</translation>
    </message>
    <message>
        <source>cannot be compared</source>
        <translation>无法比较</translation>
    </message>
    <message>
        <source>%1 at %2 mm</source>
        <translation>%1，距离 %2 mm</translation>
    </message>
    <message>
        <source>none in the base frame was read</source>
        <translation>未读取到基座坐标下的点</translation>
    </message>
    <message>
        <source>The robot is no longer where this move begins: close, and rehearse again.</source>
        <translation>机器人已不在此移动的起点：请关闭后重新预检。</translation>
    </message>
    <message>
        <source>Not sent: the place could not be read.</source>
        <translation>未发送：无法读取位置。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>a place that was not read</source>
        <translation>未读取的位置</translation>
    </message>
    <message>
        <source>Under way: %1</source>
        <translation>移动中：%1</translation>
    </message>
    <message>
        <source>Move sent…</source>
        <translation>移动已发送…</translation>
    </message>
    <message>
        <source>Arrived: %1</source>
        <translation>已到达：%1</translation>
    </message>
    <message>
        <source>Stopped at %1. That is not the target.</source>
        <translation>停在 %1。该位置不是目标。</translation>
    </message>
    <message>
        <source>At rest at %1. Whether that is the target cannot be told in this frame.</source>
        <translation>静止于 %1。在此坐标系下无法判断该位置是否为目标。</translation>
    </message>
    <message>
        <source>No answer to the move: whether it was begun is unknown. It was sent once. Look at the robot.</source>
        <translation>移动无应答：是否已开始移动未知。该命令只发送了一次。请查看机器人。</translation>
    </message>
    <message>
        <source>The outcome is unknown: communication was lost, or it does not come to rest. Look at the robot.</source>
        <translation>结果未知：通信中断，或机器人未静止。请查看机器人。</translation>
    </message>
</context>
<context>
    <name>dialogs::NumberingDialog</name>
    <message>
        <source>Variable numbering — %1</source>
        <translation>变量编号 — %1</translation>
    </message>
    <message>
        <source>Number of the variable</source>
        <translation>变量编号</translation>
    </message>
    <message>
        <source>Value on the pendant</source>
        <translation>示教编程器上的值</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>尚未读取</translation>
    </message>
    <message>
        <source>reads on the pendant</source>
        <translation>在示教编程器上的值</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Keep the result</source>
        <translation>保留结果</translation>
    </message>
    <message>
        <source>Which number is which?</source>
        <translation>哪个编号对应哪个变量？</translation>
    </message>
    <message>
        <source>Parameter RS022 decides whether B000 is number 0 or number 1 on the network. Until that is known, a write could hit the neighbour, so none is sent. Read two variables on the pendant (main menu, VARIABLE, BYTE) and enter what you see. This test only reads.</source>
        <translation>参数 RS022 决定 B000 在网络上是编号 0 还是编号 1。在此未知之前，写入可能落到相邻的变量，因此不会发送任何写入。请在示教编程器上查看两个变量（主菜单，变量 VARIABLE，字节型 BYTE），并输入所看到的值。此测试仅进行读取。</translation>
    </message>
    <message>
        <source>The variables could not be read: %1.</source>
        <translation>无法读取变量：%1。</translation>
    </message>
    <message>
        <source>All B variables hold the same value, which proves nothing: let a job or the pendant set B010 to 1 and B011 to 2, then open this test again.</source>
        <translation>所有 B 变量的值都相同，无法作出判断：请通过程序或示教编程器将 B010 设为 1、B011 设为 2，然后再次打开此测试。</translation>
    </message>
    <message>
        <source>These two tell the numberings apart.</source>
        <translation>这两个变量可以区分两种编号方式。</translation>
    </message>
    <message>
        <source>Verified: number 0 on the network is B000.</source>
        <translation>已验证：网络编号 0 为 B000。</translation>
    </message>
    <message>
        <source>Verified, shifted: number 1 on the network is B000.</source>
        <translation>已验证，有偏移：网络编号 1 为 B000。</translation>
    </message>
    <message>
        <source>Both numberings fit these values: choose variables whose neighbours hold other values.</source>
        <translation>两种编号方式都符合这些值：请选择与相邻变量的值不同的变量。</translation>
    </message>
    <message>
        <source>Neither numbering fits: read the values again, they may have changed.</source>
        <translation>两种编号方式都不符合：请重新读取，值可能已改变。</translation>
    </message>
</context>
<context>
    <name>dialogs::OverwriteDialog</name>
    <message numerus="yes">
        <source>For the remaining %n file(s) too</source>
        <translation>
            <numerusform>其余 %n 个文件也按此处理</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” exists</source>
        <translation>“%1”已存在</translation>
    </message>
    <message>
        <source>There is a file “%1” %2 already.</source>
        <translation>%2 已有文件“%1”。</translation>
    </message>
    <message>
        <source>&amp;Compare…</source>
        <translation>比较(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>替换(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Keep both</source>
        <translation>两者都保留(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>跳过(&amp;S)</translation>
    </message>
</context>
<context>
    <name>dialogs::PasscodeDialog</name>
    <message>
        <source>The passcode guards against mistakes, not against attackers: whoever can change this user&apos;s files can remove it.</source>
        <translation>密码用于防止误操作，不能防范攻击：能够更改此用户文件的人都可以移除密码。</translation>
    </message>
    <message>
        <source>Access level: %1</source>
        <translation>访问级别：%1</translation>
    </message>
    <message>
        <source>Passcode</source>
        <translation>密码</translation>
    </message>
    <message>
        <source>That is not the passcode.</source>
        <translation>密码不正确。</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>正在检查…</translation>
    </message>
</context>
<context>
    <name>dialogs::PositionDialog</name>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>暂存</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 或 %2</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>用户坐标</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形态</translation>
    </message>
    <message>
        <source>Extended form</source>
        <translation>扩展形态</translation>
    </message>
    <message>
        <source>Take the present position of R1 (base frame)</source>
        <translation>取 R1 当前位置（基座坐标）</translation>
    </message>
    <message>
        <source>Take R1 in pulses</source>
        <translation>取 R1 当前位置（脉冲）</translation>
    </message>
    <message>
        <source>Take the present position of B1 (base frame)</source>
        <translation>取 B1 当前位置（基座坐标）</translation>
    </message>
    <message>
        <source>Take B1 in pulses</source>
        <translation>取 B1 当前位置（脉冲）</translation>
    </message>
    <message>
        <source>Take the present position of S1</source>
        <translation>取 S1 当前位置</translation>
    </message>
    <message>
        <source>live: %1</source>
        <translation>实时：%1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis: reason</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>A user-frame position needs a user frame from 1 to 63.</source>
        <translation>用户坐标下的位置需要指定 1 至 63 的用户坐标号。</translation>
    </message>
    <message>
        <source>Sources disagree which code means user and which means tool frame: check on the pendant before a job uses this position.</source>
        <translation>关于哪个代码表示用户坐标、哪个表示工具坐标，各资料说法不一：在程序使用此位置之前，请在示教编程器上确认。</translation>
    </message>
    <message>
        <source>The position is being read…</source>
        <translation>正在读取位置…</translation>
    </message>
    <message>
        <source>The position could not be read: %1.</source>
        <translation>无法读取位置：%1。</translation>
    </message>
</context>
<context>
    <name>dialogs::ProfileForm</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Host name or address</source>
        <translation>主机名或地址</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>机型</translation>
    </message>
    <message>
        <source>Text encoding</source>
        <translation>文本编码</translation>
    </message>
    <message>
        <source>Variable numbering</source>
        <translation>变量编号</translation>
    </message>
    <message>
        <source>B000 is number 0 on the wire</source>
        <translation>B000 在网络上是编号 0</translation>
    </message>
    <message>
        <source>B000 is number 1 on the wire</source>
        <translation>B000 在网络上是编号 1</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>文件端口</translation>
    </message>
    <message>
        <source>Read time-out</source>
        <translation>读取超时</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>File time-out</source>
        <translation>文件超时</translation>
    </message>
    <message>
        <source>Servo time-out</source>
        <translation>伺服超时</translation>
    </message>
    <message>
        <source>Repeats of a read</source>
        <translation>读取重试次数</translation>
    </message>
    <message>
        <source>Requests outstanding at once</source>
        <translation>同时未完成的请求数</translation>
    </message>
    <message>
        <source>Requests a second, at most</source>
        <translation>每秒请求数上限</translation>
    </message>
    <message>
        <source>Jog and move, at most</source>
        <translation>点动和移动的上限</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>从 %1 到 %2</translation>
    </message>
</context>
<context>
    <name>dialogs::ReadinessSheet</name>
    <message>
        <source>Readiness — %1</source>
        <translation>就绪状态 — %1</translation>
    </message>
    <message>
        <source>What %1 allows now</source>
        <translation>%1 当前允许的操作</translation>
    </message>
    <message>
        <source>Readiness</source>
        <translation>就绪状态</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the readiness and a diagnosis</source>
        <translation>复制就绪状态和诊断结果</translation>
    </message>
    <message>
        <source>As text for support, with a diagnosis of the link, which takes a moment.</source>
        <translation>以文本形式复制，供技术支持使用；包含链路诊断，需要片刻。</translation>
    </message>
    <message>
        <source>Test numbering…</source>
        <translation>测试编号…</translation>
    </message>
    <message>
        <source>It needs a link to the controller.</source>
        <translation>需要与控制器的链路。</translation>
    </message>
    <message>
        <source>Communication lost at %1: what is hatched was read before.</source>
        <translation>通信于 %1 中断：带斜线的内容是此前读取的。</translation>
    </message>
    <message>
        <source>%1 has not answered yet.</source>
        <translation>%1 尚未应答。</translation>
    </message>
    <message>
        <source>Not connected: nothing is read.</source>
        <translation>未连接：不读取任何内容。</translation>
    </message>
    <message>
        <source>The status was not read just now.</source>
        <translation>刚才未读取到状态。</translation>
    </message>
    <message>
        <source>It is read live and changes nothing. HOLD works meanwhile: Pause key.</source>
        <translation>实时读取，不作任何更改。期间 HOLD 有效：Pause 键。</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>已复制</translation>
    </message>
</context>
<context>
    <name>dialogs::RestoreDialog</name>
    <message>
        <source>Put that file back</source>
        <translation>放回该文件</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Restore %1 from %2</source>
        <translation>从 %2 恢复 %1</translation>
    </message>
    <message>
        <source>What would be done</source>
        <translation>将执行的操作</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>What is done</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>+ new: it is sent</source>
        <translation>+ 新增：将发送</translation>
    </message>
    <message>
        <source>≠ changed: it is replaced</source>
        <translation>≠ 已改变：将替换</translation>
    </message>
    <message>
        <source>= same: left alone</source>
        <translation>= 相同：不改动</translation>
    </message>
    <message>
        <source>▲ not allowed: left alone</source>
        <translation>▲ 不允许：不改动</translation>
    </message>
    <message numerus="yes">
        <source>Back up, then restore %n file(s)</source>
        <translation>
            <numerusform>备份，然后恢复 %n 个文件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) are the same and not listed.</source>
        <translation>
            <numerusform>%n 个文件相同，未列出。</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Sending file %1 of %2…</source>
        <translation>正在发送第 %1 个文件，共 %2 个…</translation>
    </message>
    <message>
        <source>Fresh backup: file %1 of %2…</source>
        <translation>新备份：第 %1 个文件，共 %2 个…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored and read back.</source>
        <translation>
            <numerusform>%n 个文件已恢复并回读。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored before that.</source>
        <translation>
            <numerusform>在此之前已恢复 %n 个文件。</numerusform>
        </translation>
    </message>
    <message>
        <source>It was cancelled.</source>
        <translation>已取消。</translation>
    </message>
    <message>
        <source>Stopped at %1.</source>
        <translation>停止于 %1。</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>未发送任何内容。</translation>
    </message>
    <message>
        <source>The file is as it was before.</source>
        <translation>该文件与之前相同。</translation>
    </message>
    <message>
        <source>▲ The file could not be put back. Look at the controller.</source>
        <translation>▲ 无法放回该文件。请查看控制器。</translation>
    </message>
    <message>
        <source>A fresh backup of %1 is made first. Then the files below are sent one by one and read back. A refused file is left out; it stops at any other error.</source>
        <translation>先对 %1 做一次新的备份。然后逐个发送以下文件并回读。被拒绝的文件会跳过；遇到任何其他错误即停止。</translation>
    </message>
    <message>
        <source>%1: the backup is of %2, the controller is %3.</source>
        <translation>%1：备份为 %2，控制器为 %3。</translation>
    </message>
    <message>
        <source>This is the backup of another robot: nothing of it is sent.</source>
        <translation>这是另一台机器人的备份：不会发送其中任何内容。</translation>
    </message>
    <message>
        <source>The controller refused %1; the other files were sent.</source>
        <translation>控制器拒绝了 %1；其他文件已发送。</translation>
    </message>
</context>
<context>
    <name>dialogs::SignalPicker</name>
    <message>
        <source>Add a signal</source>
        <translation>添加信号</translation>
    </message>
    <message>
        <source>For example: R1 torque, B005, #00010, M012</source>
        <translation>例如：R1 转矩、B005、#00010、M012</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>dialogs::StartSheet</name>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Start at %1</source>
        <translation>在 %1 启动</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>From line</source>
        <translation>起始行</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>速度倍率</translation>
    </message>
    <message>
        <source>HOLD: Pause key</source>
        <translation>HOLD：Pause 键</translation>
    </message>
    <message>
        <source>The robot will move</source>
        <translation>机器人将会移动</translation>
    </message>
    <message>
        <source>With the keyboard: type %1, then F9</source>
        <translation>使用键盘：输入 %1，然后按 F9</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Start sent…</source>
        <translation>启动已发送…</translation>
    </message>
    <message>
        <source>Accepted. Waiting for RUN…</source>
        <translation>已接受。等待 RUN…</translation>
    </message>
    <message>
        <source>The start was accepted, but no RUN was seen for 3 s. Usual causes: the job was so short that it has ended, it waits for a condition of the cell, or the pendant shows a question. Look at the pendant.</source>
        <translation>启动已被接受，但 3 s 内未见 RUN。常见原因：程序很短，已经结束；程序在等待单元的某个条件；或示教编程器上有询问。请查看示教编程器。</translation>
    </message>
    <message>
        <source>No answer to the start: it may or may not have happened. Reading the status…</source>
        <translation>启动无应答：可能已执行，也可能未执行。正在读取状态…</translation>
    </message>
    <message>
        <source>No answer to the start, and none to the status: whether the robot runs is unknown. Look at it.</source>
        <translation>启动无应答，状态也无应答：机器人是否在运行未知。请查看机器人。</translation>
    </message>
    <message>
        <source>No answer to the start, but a status that was read afterwards said RUN. It was sent once.</source>
        <translation>启动无应答，但之后读取的状态显示 RUN。该命令只发送了一次。</translation>
    </message>
    <message>
        <source>No answer to the start, and a status that was read afterwards said no RUN. Look at the robot before you start again.</source>
        <translation>启动无应答，且之后读取的状态未显示 RUN。再次启动之前请查看机器人。</translation>
    </message>
</context>
<context>
    <name>dialogs::WhyNotDialog</name>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>What must be the case</source>
        <translation>必须满足的条件</translation>
    </message>
</context>
<context>
    <name>files::Identity</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>主机</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>机型</translation>
    </message>
    <message>
        <source>Robots and axes</source>
        <translation>机器人和轴</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>软件</translation>
    </message>
    <message>
        <source>Number of variables</source>
        <translation>变量数</translation>
    </message>
</context>
<context>
    <name>files::Restore</name>
    <message>
        <source>It is not in the backup.</source>
        <translation>备份中没有该文件。</translation>
    </message>
    <message>
        <source>What the controller has could not be read.</source>
        <translation>无法读取控制器中的内容。</translation>
    </message>
    <message>
        <source>In the backup it is not as it was written.</source>
        <translation>备份中的内容与写入时不同。</translation>
    </message>
    <message>
        <source>It belongs to this one controller, or only tells what happened: it is never sent.</source>
        <translation>它只属于这一台控制器，或只记录发生过的事：绝不会发送。</translation>
    </message>
    <message>
        <source>It comes from another robot.</source>
        <translation>它来自另一台机器人。</translation>
    </message>
    <message>
        <source>It changes how the robot moves, or what protects people: look at the differences and choose it.</source>
        <translation>它会改变机器人的动作方式或对人员的保护：请查看差异后再选择。</translation>
    </message>
</context>
<context>
    <name>files::Verify</name>
    <message>
        <source>This is no backup: %1 is missing or of another kind.</source>
        <translation>这不是备份：%1 缺失或类型不符。</translation>
    </message>
    <message>
        <source>%1 is not as it was written.</source>
        <translation>%1 与写入时不同。</translation>
    </message>
    <message>
        <source>%1 was changed.</source>
        <translation>%1 已被更改。</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1 缺失。</translation>
    </message>
    <message>
        <source>%1 does not belong to the backup.</source>
        <translation>%1 不属于该备份。</translation>
    </message>
</context>
<context>
    <name>inform::Check</name>
    <message>
        <source>The file is empty.</source>
        <translation>文件为空。</translation>
    </message>
    <message>
        <source>HSES cannot carry it.</source>
        <translation>HSES 无法传输该文件。</translation>
    </message>
    <message>
        <source>“%1” is no type of file that can be sent.</source>
        <translation>“%1”不是可以发送的文件类型。</translation>
    </message>
    <message>
        <source>Controllers take JBI, JBR, CND, DAT, PRM and LST.</source>
        <translation>控制器接受 JBI、JBR、CND、DAT、PRM 和 LST。</translation>
    </message>
    <message>
        <source>The type of the file is written in small letters.</source>
        <translation>文件类型用小写字母书写。</translation>
    </message>
    <message>
        <source>Controllers write it in capitals.</source>
        <translation>控制器使用大写字母。</translation>
    </message>
    <message>
        <source>The header names the job “%1”.</source>
        <translation>文件头中的程序名为“%1”。</translation>
    </message>
    <message>
        <source>The name in the header counts: that job would be written.</source>
        <translation>以文件头中的名称为准：将写入该程序。</translation>
    </message>
    <message>
        <source>The job is being executed.</source>
        <translation>该程序正在执行。</translation>
    </message>
    <message>
        <source>A running job cannot be replaced.</source>
        <translation>无法替换正在运行的程序。</translation>
    </message>
    <message>
        <source>All names in the controller become those in this file.</source>
        <translation>控制器中的所有名称都将变为此文件中的名称。</translation>
    </message>
    <message>
        <source>Back them up first.</source>
        <translation>请先备份这些名称。</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark.</source>
        <translation>文件以字节顺序标记开头。</translation>
    </message>
    <message>
        <source>Controllers know no such mark: save the file without it.</source>
        <translation>控制器不识别此标记：请以不带标记的方式保存文件。</translation>
    </message>
    <message>
        <source>The file is UTF-16 text.</source>
        <translation>该文件是 UTF-16 文本。</translation>
    </message>
    <message>
        <source>Controllers take one byte for a letter.</source>
        <translation>控制器中一个字母占一个字节。</translation>
    </message>
    <message>
        <source>The lines end in CR alone.</source>
        <translation>行尾只有 CR。</translation>
    </message>
    <message>
        <source>Lines end in CR LF; the controller finds neither NOP nor END (pendant 3200).</source>
        <translation>行应以 CR LF 结尾；控制器既找不到 NOP 也找不到 END（示教编程器 3200）。</translation>
    </message>
    <message>
        <source>Lines end in LF alone.</source>
        <translation>行尾只有 LF。</translation>
    </message>
    <message>
        <source>Lines end in CR LF; the controller finds neither NOP nor END (0x5130, pendant 3200).</source>
        <translation>行应以 CR LF 结尾；控制器既找不到 NOP 也找不到 END（0x5130，示教编程器 3200）。</translation>
    </message>
    <message>
        <source>Lines end in CR LF; a controller may read such a file as empty.</source>
        <translation>行应以 CR LF 结尾；控制器可能将此类文件读作空文件。</translation>
    </message>
    <message>
        <source>The last line does not end.</source>
        <translation>最后一行没有行尾。</translation>
    </message>
    <message>
        <source>Controllers end each line in CR LF.</source>
        <translation>控制器的每一行都以 CR LF 结尾。</translation>
    </message>
    <message>
        <source>There is a Ctrl-Z at the end.</source>
        <translation>末尾有 Ctrl-Z。</translation>
    </message>
    <message>
        <source>It stands behind END, which must be last (0x5130).</source>
        <translation>它位于 END 之后，而 END 必须在最后 (0x5130)。</translation>
    </message>
    <message>
        <source>There is a control character.</source>
        <translation>有控制字符。</translation>
    </message>
    <message>
        <source>No line of a job may have one.</source>
        <translation>程序的任何一行都不得含有控制字符。</translation>
    </message>
    <message>
        <source>This is no job: it does not have the line /JOB.</source>
        <translation>这不是程序：没有 /JOB 行。</translation>
    </message>
    <message>
        <source>A job begins with it (0x5310).</source>
        <translation>程序以该行开头 (0x5310)。</translation>
    </message>
    <message>
        <source>The file holds more than one job.</source>
        <translation>文件含有多个程序。</translation>
    </message>
    <message>
        <source>Only the first one was looked at.</source>
        <translation>仅检查了第一个程序。</translation>
    </message>
    <message>
        <source>“%1” is no name for a job.</source>
        <translation>“%1”不能作为程序名。</translation>
    </message>
    <message>
        <source>A name has 1 to 32 bytes, no blanks and none of the signs that names of files may not have (0x4190).</source>
        <translation>程序名为 1 至 32 字节，不含空格，也不含文件名中不允许的符号 (0x4190)。</translation>
    </message>
    <message>
        <source>There is text that belongs to no section.</source>
        <translation>有不属于任何段的文本。</translation>
    </message>
    <message>
        <source>It is no INFORM (0x5310).</source>
        <translation>它不是 INFORM (0x5310)。</translation>
    </message>
    <message>
        <source>%1 is no known pseudo instruction.</source>
        <translation>%1 不是已知的伪指令。</translation>
    </message>
    <message>
        <source>A controller that does not know it refuses the file (0x5340).</source>
        <translation>不识别该伪指令的控制器会拒绝此文件 (0x5340)。</translation>
    </message>
    <message>
        <source>The comment of the job is longer than 32 bytes.</source>
        <translation>程序的注释超过 32 字节。</translation>
    </message>
    <message>
        <source>Controllers cut it or refuse it.</source>
        <translation>控制器会将其截断或拒绝。</translation>
    </message>
    <message>
        <source>A frame is given, and the attribute RJ is missing.</source>
        <translation>指定了坐标，但缺少属性 RJ。</translation>
    </message>
    <message>
        <source>Only relative jobs have a frame (0x4490).</source>
        <translation>只有相对程序才有坐标 (0x4490)。</translation>
    </message>
    <message>
        <source>The job is relative, and no frame is given.</source>
        <translation>该程序为相对程序，但未指定坐标。</translation>
    </message>
    <message>
        <source>A relative job names its frame (0x3390).</source>
        <translation>相对程序须指定其坐标 (0x3390)。</translation>
    </message>
    <message>
        <source>There are positions, and no ///NPOS that counts them.</source>
        <translation>有位置，但没有统计位置数的 ///NPOS。</translation>
    </message>
    <message>
        <source>The controller compares them (0x5180).</source>
        <translation>控制器会比较两者 (0x5180)。</translation>
    </message>
    <message>
        <source>///NPOS does not count the positions of each kind: %1 (kind, said, found).</source>
        <translation>///NPOS 与各种位置的数量不符：%1（种类，声明数，实际数）。</translation>
    </message>
    <message>
        <source>There is text among the positions that is none.</source>
        <translation>位置之间有不是位置的文本。</translation>
    </message>
    <message>
        <source>Every line of //POS is a position or a pseudo instruction (0x5120).</source>
        <translation>//POS 的每一行都是位置或伪指令 (0x5120)。</translation>
    </message>
    <message>
        <source>%1 is there twice.</source>
        <translation>%1 出现了两次。</translation>
    </message>
    <message>
        <source>Each position has one entry (0x5120).</source>
        <translation>每个位置只有一个条目 (0x5120)。</translation>
    </message>
    <message>
        <source>%1 is named by no line.</source>
        <translation>没有任何行使用 %1。</translation>
    </message>
    <message>
        <source>Each taught point belongs to one instruction (pendant 3190).</source>
        <translation>每个示教点属于一条命令（示教编程器 3190）。</translation>
    </message>
    <message>
        <source>%1 has no entry among the positions.</source>
        <translation>%1 在位置中没有条目。</translation>
    </message>
    <message>
        <source>The robot would not know where to go (0x4130).</source>
        <translation>机器人将无法得知移动到何处 (0x4130)。</translation>
    </message>
    <message>
        <source>%1 is named in two places.</source>
        <translation>%1 在两处被使用。</translation>
    </message>
    <message>
        <source>Controllers give each place a point of its own.</source>
        <translation>控制器为每一处分配各自的点。</translation>
    </message>
    <message>
        <source>The number of values does not fit the axes: %1 (position, values).</source>
        <translation>值的数量与轴数不符：%1（位置，值）。</translation>
    </message>
    <message>
        <source>A robot has 6 or 7 axes, a base 1 to 3, a station 1 to 6 (0x5180).</source>
        <translation>机器人有 6 或 7 轴，基座轴为 1 至 3 轴，工装轴为 1 至 6 轴 (0x5180)。</translation>
    </message>
    <message>
        <source>%1 has a value that is no number.</source>
        <translation>%1 有一个值不是数。</translation>
    </message>
    <message>
        <source>The controller cannot read it (0x5120).</source>
        <translation>控制器无法读取该值 (0x5120)。</translation>
    </message>
    <message>
        <source>The line ///PULSE, ///RECTAN or ///ANGLE before %1 does not fit its ///POSTYPE.</source>
        <translation>%1 之前的 ///PULSE、///RECTAN 或 ///ANGLE 行与其 ///POSTYPE 不符。</translation>
    </message>
    <message>
        <source>PULSE goes with ///PULSE, ANGLE with ///ANGLE, the others with ///RECTAN (0x5120).</source>
        <translation>PULSE 对应 ///PULSE，ANGLE 对应 ///ANGLE，其余对应 ///RECTAN (0x5120)。</translation>
    </message>
    <message>
        <source>%1 is in pulses, and the job is relative.</source>
        <translation>%1 以脉冲表示，而该程序为相对程序。</translation>
    </message>
    <message>
        <source>The points of a relative job stand in its frame.</source>
        <translation>相对程序的点以其坐标表示。</translation>
    </message>
    <message>
        <source>There are taught points (%1), and the job has no control group.</source>
        <translation>有示教点 (%1)，但该程序没有控制轴组。</translation>
    </message>
    <message>
        <source>A job without a group cannot move (0x5430).</source>
        <translation>没有控制轴组的程序无法移动 (0x5430)。</translation>
    </message>
    <message>
        <source>There are %1 points, and no control group of the job has such axes.</source>
        <translation>有 %1 点，但程序的控制轴组中没有此类轴。</translation>
    </message>
    <message>
        <source>C needs a robot, BC a base, EC a station among the groups (0x3370).</source>
        <translation>控制轴组中，C 需要机器人轴，BC 需要基座轴，EC 需要工装轴 (0x3370)。</translation>
    </message>
    <message>
        <source>The first instruction is not NOP.</source>
        <translation>第一条命令不是 NOP。</translation>
    </message>
    <message>
        <source>Every job begins with NOP (0x5130, pendant 3200).</source>
        <translation>每个程序都以 NOP 开头（0x5130，示教编程器 3200）。</translation>
    </message>
    <message>
        <source>The last instruction is not END.</source>
        <translation>最后一条命令不是 END。</translation>
    </message>
    <message>
        <source>Every job ends with END (0x5130, pendant 3200).</source>
        <translation>每个程序都以 END 结尾（0x5130，示教编程器 3200）。</translation>
    </message>
    <message>
        <source>There is an END before the last line.</source>
        <translation>最后一行之前有 END。</translation>
    </message>
    <message>
        <source>What follows it is no job (0x5130).</source>
        <translation>其后的内容不属于程序 (0x5130)。</translation>
    </message>
    <message>
        <source>The line begins with no instruction.</source>
        <translation>该行不是以命令开头。</translation>
    </message>
    <message>
        <source>An instruction was cut in two: it belongs to the line before (0x5110).</source>
        <translation>命令被断成两段：此行属于上一行 (0x5110)。</translation>
    </message>
    <message>
        <source>%1 is no instruction that this program knows.</source>
        <translation>%1 不是本软件已知的命令。</translation>
    </message>
    <message>
        <source>It may belong to an option; a controller without it refuses the job (0x5110).</source>
        <translation>它可能属于某个选项；没有该选项的控制器会拒绝此程序 (0x5110)。</translation>
    </message>
    <message>
        <source>There are characters beyond ASCII outside of comments and texts.</source>
        <translation>在注释和文本以外有非 ASCII 字符。</translation>
    </message>
    <message>
        <source>Instructions are ASCII.</source>
        <translation>命令为 ASCII。</translation>
    </message>
    <message>
        <source>There is an empty line among the instructions.</source>
        <translation>命令之间有空行。</translation>
    </message>
    <message>
        <source>Controllers write none.</source>
        <translation>控制器不写空行。</translation>
    </message>
    <message>
        <source>The job has more than 10,000 lines.</source>
        <translation>程序超过 10,000 行。</translation>
    </message>
    <message>
        <source>Controllers number lines to 9999.</source>
        <translation>控制器的行号最大为 9999。</translation>
    </message>
    <message>
        <source>A comment or message is longer than 32 bytes.</source>
        <translation>注释或信息超过 32 字节。</translation>
    </message>
    <message>
        <source>Controllers cut it.</source>
        <translation>控制器会将其截断。</translation>
    </message>
    <message>
        <source>The label *%1 is longer than 8 bytes.</source>
        <translation>标号 *%1 超过 8 字节。</translation>
    </message>
    <message>
        <source>Labels have 1 to 8 (0x4200).</source>
        <translation>标号为 1 至 8 字节 (0x4200)。</translation>
    </message>
    <message>
        <source>The label *%1 is there twice.</source>
        <translation>标号 *%1 出现了两次。</translation>
    </message>
    <message>
        <source>A jump would have two goals (0x4200).</source>
        <translation>跳转将有两个目标 (0x4200)。</translation>
    </message>
    <message>
        <source>There is no label *%1.</source>
        <translation>没有标号 *%1。</translation>
    </message>
    <message>
        <source>The jump gives an alarm when it is executed.</source>
        <translation>执行该跳转时会发生报警。</translation>
    </message>
    <message>
        <source>%1 is not closed.</source>
        <translation>%1 未闭合。</translation>
    </message>
    <message>
        <source>IFTHEN needs ENDIF, WHILE ENDWHILE, FOR NEXT, SWITCH ENDSWITCH (0x5110).</source>
        <translation>IFTHEN 需要 ENDIF，WHILE 需要 ENDWHILE，FOR 需要 NEXT，SWITCH 需要 ENDSWITCH (0x5110)。</translation>
    </message>
    <message>
        <source>%1 stands outside of what it belongs to.</source>
        <translation>%1 在其所属的结构之外。</translation>
    </message>
    <message>
        <source>Structures are closed in the reverse order (0x5110).</source>
        <translation>结构须按相反的顺序闭合 (0x5110)。</translation>
    </message>
    <message>
        <source>Structures are nested more than 10 deep.</source>
        <translation>结构嵌套超过 10 层。</translation>
    </message>
    <message>
        <source>Controllers allow 10.</source>
        <translation>控制器允许 10 层。</translation>
    </message>
    <message>
        <source>%1 is out of range.</source>
        <translation>%1 超出范围。</translation>
    </message>
    <message>
        <source>The controller may refuse it (0x5200).</source>
        <translation>控制器可能会拒绝 (0x5200)。</translation>
    </message>
    <message>
        <source>There are more than 8 arguments.</source>
        <translation>参数多于 8 个。</translation>
    </message>
    <message>
        <source>A job takes 8 (0x5110).</source>
        <translation>一个程序最多接受 8 个 (0x5110)。</translation>
    </message>
    <message>
        <source>%1 is beyond what ///LVARS provides.</source>
        <translation>%1 超出 ///LVARS 提供的范围。</translation>
    </message>
    <message>
        <source>The job has fewer local variables (0x5110).</source>
        <translation>该程序的局部变量没有这么多 (0x5110)。</translation>
    </message>
    <message>
        <source>Line %1 of the file, named by line %2: %3</source>
        <translation>文件第 %1 行（由第 %2 行使用）：%3</translation>
    </message>
    <message>
        <source>Line %1 (%2 in the file): %3</source>
        <translation>第 %1 行（文件中为第 %2 行）：%3</translation>
    </message>
    <message>
        <source>Line %1 of the file: %2</source>
        <translation>文件第 %1 行：%2</translation>
    </message>
    <message>
        <source>There is no ///NPOS.</source>
        <translation>没有 ///NPOS。</translation>
    </message>
</context>
<context>
    <name>inform::JobDiff</name>
    <message>
        <source>arm form: field %1 of RCONF %2 → %3</source>
        <translation>手臂形态：RCONF 的第 %1 项 %2 → %3</translation>
    </message>
    <message>
        <source>arm form: %1 → %2</source>
        <translation>手臂形态：%1 → %2</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>轴 %1</translation>
    </message>
    <message>
        <source>%1 pulses in %2</source>
        <translation>%2：%1 脉冲</translation>
    </message>
    <message>
        <source>%1 mm in %2</source>
        <translation>%2：%1 mm</translation>
    </message>
    <message>
        <source>%1° in %2</source>
        <translation>%2：%1°</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>合计 %1</translation>
    </message>
    <message>
        <source>moved %1</source>
        <translation>已移动 %1</translation>
    </message>
    <message>
        <source>moved %1 (%2)</source>
        <translation>已移动 %1 (%2)</translation>
    </message>
    <message>
        <source>type %1 → %2</source>
        <translation>类型 %1 → %2</translation>
    </message>
    <message>
        <source>tool %1 → %2</source>
        <translation>工具 %1 → %2</translation>
    </message>
    <message>
        <source>user frame %1 → %2</source>
        <translation>用户坐标 %1 → %2</translation>
    </message>
    <message>
        <source>marked as beyond the limit</source>
        <translation>标记为超出限位</translation>
    </message>
    <message>
        <source>no longer marked as beyond the limit</source>
        <translation>不再标记为超出限位</translation>
    </message>
    <message>
        <source>values %1 → %2</source>
        <translation>值 %1 → %2</translation>
    </message>
    <message>
        <source>Made a relative job</source>
        <translation>已变为相对程序</translation>
    </message>
    <message>
        <source>No longer a relative job</source>
        <translation>不再是相对程序</translation>
    </message>
    <message>
        <source>The job is locked against editing</source>
        <translation>程序已锁定，禁止编辑</translation>
    </message>
    <message>
        <source>The job is no longer locked against editing</source>
        <translation>程序不再禁止编辑</translation>
    </message>
    <message>
        <source>Made a macro job</source>
        <translation>已变为宏程序</translation>
    </message>
    <message>
        <source>No longer a macro job</source>
        <translation>不再是宏程序</translation>
    </message>
    <message>
        <source>Attribute %1 added</source>
        <translation>已添加属性 %1</translation>
    </message>
    <message>
        <source>Attribute %1 removed</source>
        <translation>已移除属性 %1</translation>
    </message>
    <message>
        <source>Relative frame %1 added</source>
        <translation>已添加相对坐标 %1</translation>
    </message>
    <message>
        <source>Relative frame %1 removed</source>
        <translation>已移除相对坐标 %1</translation>
    </message>
    <message>
        <source>Relative frame: %1 → %2</source>
        <translation>相对坐标：%1 → %2</translation>
    </message>
    <message>
        <source>Job name: “%1” → “%2”</source>
        <translation>程序名：“%1”→“%2”</translation>
    </message>
    <message>
        <source>Job folder: “%1” → “%2”</source>
        <translation>程序文件夹：“%1”→“%2”</translation>
    </message>
    <message>
        <source>Comment of the job: “%1” → “%2”</source>
        <translation>程序的注释：“%1”→“%2”</translation>
    </message>
    <message>
        <source>Control group GROUP%1: %2 → %3</source>
        <translation>控制轴组 GROUP%1：%2 → %3</translation>
    </message>
    <message>
        <source>Control group GROUP%1 added: %2</source>
        <translation>已添加控制轴组 GROUP%1：%2</translation>
    </message>
    <message>
        <source>Control group GROUP%1 removed: %2</source>
        <translation>已移除控制轴组 GROUP%1：%2</translation>
    </message>
    <message>
        <source>Local variables %1: %2 → %3</source>
        <translation>局部变量 %1：%2 → %3</translation>
    </message>
    <message>
        <source>Alias of %1: %2 → %3</source>
        <translation>%1 的别名：%2 → %3</translation>
    </message>
    <message>
        <source>Alias of %1 added: %2</source>
        <translation>已添加 %1 的别名：%2</translation>
    </message>
    <message>
        <source>Alias of %1 removed: %2</source>
        <translation>已移除 %1 的别名：%2</translation>
    </message>
    <message>
        <source>Argument %1: “%2” → “%3”</source>
        <translation>参数 %1：“%2”→“%3”</translation>
    </message>
    <message>
        <source>Line %1 %2</source>
        <translation>第 %1 行 %2</translation>
    </message>
    <message>
        <source>Line %1 %2 of %3</source>
        <translation>第 %1 行 %3 的 %2</translation>
    </message>
    <message>
        <source>%1: %2 %3 added</source>
        <translation>%1：已添加 %2 %3</translation>
    </message>
    <message>
        <source>%1: %2 %3 removed</source>
        <translation>%1：已移除 %2 %3</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <comment>line and instruction, before, after</comment>
        <translation>%1：%2 → %3</translation>
    </message>
    <message>
        <source>%1: %2 %3 → %4</source>
        <comment>line and instruction, operand, before, after</comment>
        <translation>%1：%2 %3 → %4</translation>
    </message>
    <message>
        <source>Line %1 added: %2</source>
        <translation>第 %1 行已添加：%2</translation>
    </message>
    <message>
        <source>Line %1 added: %2 (new point: %3)</source>
        <translation>第 %1 行已添加：%2（新的点：%3）</translation>
    </message>
    <message>
        <source>Line %1 removed: %2</source>
        <translation>第 %1 行已移除：%2</translation>
    </message>
    <message>
        <source>Line %1 removed: %2 (with its point: %3)</source>
        <translation>第 %1 行已移除：%2（及其点：%3）</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) moved from line %1 to line %2</source>
        <translation>
            <numerusform>%n 行已从第 %1 行移动到第 %2 行</numerusform>
        </translation>
    </message>
    <message>
        <source>Line %1 commented out: %2</source>
        <translation>第 %1 行已注释掉：%2</translation>
    </message>
    <message>
        <source>Line %1 no longer commented out: %2</source>
        <translation>第 %1 行不再被注释掉：%2</translation>
    </message>
    <message>
        <source>Line %1 locked against editing: %2</source>
        <translation>第 %1 行已锁定，禁止编辑：%2</translation>
    </message>
    <message>
        <source>Line %1 no longer locked against editing: %2</source>
        <translation>第 %1 行不再禁止编辑：%2</translation>
    </message>
    <message>
        <source>Line %1, comment: “%2” → “%3”</source>
        <translation>第 %1 行，注释：“%2”→“%3”</translation>
    </message>
    <message>
        <source>Line %1, comment added: “%2”</source>
        <translation>第 %1 行，已添加注释：“%2”</translation>
    </message>
    <message>
        <source>Line %1, comment removed: “%2”</source>
        <translation>第 %1 行，已移除注释：“%2”</translation>
    </message>
    <message>
        <source>Line %1: %2 → %3</source>
        <translation>第 %1 行：%2 → %3</translation>
    </message>
    <message>
        <source>%1 added: %2</source>
        <comment>a position</comment>
        <translation>%1 已添加：%2</translation>
    </message>
    <message>
        <source>%1 removed: %2</source>
        <comment>a position</comment>
        <translation>%1 已移除：%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a position</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>journal</name>
    <message>
        <source>%n record(s) of the journal are lost: neither the journal nor %1 could be written.</source>
        <translation>%n 条日志记录已丢失：日志和 %1 均无法写入。</translation>
    </message>
    <message>
        <source>%n record(s) could not be written into the journal. Orders and notes are kept in %1.</source>
        <translation>%n 条记录无法写入日志。命令和备注保存在 %1 中。</translation>
    </message>
    <message>
        <source>What an earlier program left for the journal cannot be read: %1</source>
        <translation>无法读取先前的软件为日志留下的内容：%1</translation>
    </message>
</context>
<context>
    <name>journal::Database</name>
    <message>
        <source>The folder of the journal cannot be made.</source>
        <translation>无法创建日志文件夹。</translation>
    </message>
    <message>
        <source>The journal was made by a newer version of Pendesk.</source>
        <translation>该日志由更新版本的 Pendesk 创建。</translation>
    </message>
    <message>
        <source>The damaged journal cannot be given another name.</source>
        <translation>无法重命名已损坏的日志。</translation>
    </message>
</context>
<context>
    <name>journal::Store</name>
    <message>
        <source>The journal cannot be written: %1. Work goes on; records wait in memory.</source>
        <translation>无法写入日志：%1。可继续工作；记录在内存中等待写入。</translation>
    </message>
    <message>
        <source>the disk does not answer</source>
        <translation>磁盘没有应答</translation>
    </message>
</context>
<context>
    <name>models::ActiveAlarmModel</name>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Sub code</source>
        <translation>子代码</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>控制器时间</translation>
    </message>
    <message>
        <source>First seen</source>
        <translation>首次出现</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>The controller tells the newest four alarms only, and this is not one of them. It may be active.</source>
        <translation>控制器只报告最新的四个报警，此报警不在其中。它可能仍然存在。</translation>
    </message>
    <message>
        <source>First seen by this computer: %1</source>
        <translation>本计算机首次读到：%1</translation>
    </message>
</context>
<context>
    <name>models::AlarmHistoryModel</name>
    <message>
        <source>Controller time</source>
        <translation>控制器时间</translation>
    </message>
    <message>
        <source>List</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Sub code</source>
        <translation>子代码</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Read here</source>
        <translation>本机读取时间</translation>
    </message>
</context>
<context>
    <name>models::CodeStatisticsModel</name>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>Mean time between</source>
        <translation>平均间隔</translation>
    </message>
    <message>
        <source>Last, controller time</source>
        <translation>最后一次，控制器时间</translation>
    </message>
    <message>
        <source>%1 d %2 h</source>
        <translation>%1 d %2 h</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>under a minute</source>
        <translation>不到一分钟</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
</context>
<context>
    <name>models::FleetModel</name>
    <message>
        <source>ALARM</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>HELD</source>
        <translation>HOLD 中</translation>
    </message>
    <message>
        <source>Hold: %1</source>
        <translation>HOLD：%1</translation>
    </message>
    <message>
        <source>RUNNING</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>TEACH</source>
        <translation>TEACH</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>NO LINK</source>
        <translation>无链路</translation>
    </message>
    <message>
        <source>CHECKING</source>
        <translation>检查中</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>OFF</source>
        <translation>OFF</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1：%2。%3</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>伺服</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>往返时间</translation>
    </message>
</context>
<context>
    <name>models::IncidentModel</name>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
</context>
<context>
    <name>models::IoModel</name>
    <message>
        <source>refused</source>
        <translation>被拒绝</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1。%2</translation>
    </message>
</context>
<context>
    <name>models::JobListModel</name>
    <message>
        <source>%1 is being executed.</source>
        <translation>%1 正在执行。</translation>
    </message>
    <message>
        <source>%1, favourite</source>
        <translation>%1，收藏</translation>
    </message>
</context>
<context>
    <name>models::OrderModel</name>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>变化</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>应答</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>计算机</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>级别</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
</context>
<context>
    <name>models::QueueModel</name>
    <message>
        <source>waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>under way</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>done, read back identical</source>
        <translation>完成，回读一致</translation>
    </message>
    <message numerus="yes">
        <source>done, the controller reformatted %n line(s)</source>
        <translation>
            <numerusform>完成，控制器重排了 %n 行</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ read back different</source>
        <translation>▲ 回读不一致</translation>
    </message>
    <message>
        <source>▲ sent, but it could not be read back</source>
        <translation>▲ 已发送，但无法回读</translation>
    </message>
    <message>
        <source>← to the computer</source>
        <translation>← 到计算机</translation>
    </message>
    <message>
        <source>→ to the controller</source>
        <translation>→ 到控制器</translation>
    </message>
    <message>
        <source>✕ delete</source>
        <translation>✕ 删除</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>字节</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>Remaining</source>
        <translation>剩余</translation>
    </message>
</context>
<context>
    <name>models::TrackModel</name>
    <message>
        <source>Not read at that time.</source>
        <translation>该时刻未读取。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Min in view</source>
        <translation>视图内最小</translation>
    </message>
    <message>
        <source>Max in view</source>
        <translation>视图内最大</translation>
    </message>
</context>
<context>
    <name>models::VariableModel</name>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>上一值</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>改变时间</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>(empty)</source>
        <translation>（空）</translation>
    </message>
    <message>
        <source>%1 (local)</source>
        <translation>%1（局部）</translation>
    </message>
    <message>
        <source>reads %1</source>
        <translation>读到 %1</translation>
    </message>
    <message>
        <source>→ %1</source>
        <comment>new value</comment>
        <translation>→ %1</translation>
    </message>
    <message>
        <source>wrote %1, reads %2</source>
        <translation>写入 %1，读到 %2</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <comment>old and new value</comment>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>not sent yet</source>
        <translation>尚未发送</translation>
    </message>
    <message>
        <source>not sent: %1</source>
        <translation>未发送：%1</translation>
    </message>
    <message>
        <source>being written…</source>
        <translation>正在写入…</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>被拒绝：%1</translation>
    </message>
    <message>
        <source>outcome unknown, look at the robot: %1</source>
        <translation>结果未知，请查看机器人：%1</translation>
    </message>
    <message>
        <source>accepted, but another value was read back</source>
        <translation>已接受，但回读到其他值</translation>
    </message>
    <message>
        <source>The controller calls it “%1”.</source>
        <translation>控制器中的名称为“%1”。</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>B007, value: 17</comment>
        <translation>%1，%2：%3</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>被拒绝</translation>
    </message>
</context>
<context>
    <name>models::WatchModel</name>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>In jobs</source>
        <translation>所在程序</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Rising edges</source>
        <translation>上升沿</translation>
    </message>
    <message>
        <source>Falling edges</source>
        <translation>下降沿</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>改变时间</translation>
    </message>
</context>
<context>
    <name>motion::JogStep</name>
    <message>
        <source>A step must be above 0 and at most %1 pulses.</source>
        <translation>步距必须大于 0 且不超过 %1 脉冲。</translation>
    </message>
    <message>
        <source>A step must be above 0 and at most %1 mm.</source>
        <translation>步距必须大于 0 且不超过 %1 mm。</translation>
    </message>
    <message>
        <source>A step must be above 0 and at most %1°.</source>
        <translation>步距必须大于 0 且不超过 %1°。</translation>
    </message>
    <message>
        <source>The present position was not read.</source>
        <translation>未读取到当前位置。</translation>
    </message>
    <message>
        <source>The group has no such axis.</source>
        <translation>该控制轴组没有此轴。</translation>
    </message>
</context>
<context>
    <name>motion::Plan</name>
    <message>
        <source>The speed must be above 0 and at most %1 mm/s.</source>
        <translation>速度必须大于 0 且不超过 %1 mm/s。</translation>
    </message>
    <message>
        <source>The rotation speed must be above 0 and at most %1 °/s.</source>
        <translation>回转速度必须大于 0 且不超过 %1 °/s。</translation>
    </message>
    <message>
        <source>The joint speed must be above 0 and at most %1 %.</source>
        <translation>关节速度必须大于 0 且不超过 %1 %。</translation>
    </message>
    <message>
        <source>Where this frame stands cannot be read over HSES, so nobody here knows how far the move would go: use the base frame or an increment.</source>
        <translation>此坐标系的位置无法通过 HSES 读取，因此在此无法得知移动的距离：请使用基座坐标或增量。</translation>
    </message>
    <message>
        <source>This robot stands on base axes, and HSES does not tell where they are in mm: enter where they shall be.</source>
        <translation>此机器人安装在基座轴上，而 HSES 不提供基座轴以 mm 表示的位置：请输入基座轴的目标位置。</translation>
    </message>
    <message>
        <source>The position has no six axes.</source>
        <translation>该位置没有六个轴。</translation>
    </message>
    <message>
        <source>The tool point stands outside the box of this controller.</source>
        <translation>工具控制点在此控制器的范围框之外。</translation>
    </message>
    <message>
        <source>The move would leave the box of this controller.</source>
        <translation>该移动会超出此控制器的范围框。</translation>
    </message>
    <message>
        <source>User and tool frames are off until the profile says that they were checked on the robot.</source>
        <translation>在配置中声明已在机器人上确认之前，用户坐标和工具坐标不可用。</translation>
    </message>
    <message>
        <source>The user frame must be from 1 to 63.</source>
        <translation>用户坐标号必须为 1 至 63。</translation>
    </message>
    <message>
        <source>The tool must be from 0 to 63.</source>
        <translation>工具号必须为 0 至 63。</translation>
    </message>
    <message>
        <source>A base or a station is moved in pulses.</source>
        <translation>基座轴或工装轴以脉冲移动。</translation>
    </message>
    <message>
        <source>The present position was not read.</source>
        <translation>未读取到当前位置。</translation>
    </message>
    <message>
        <source>A target in pulses can only be reached by a joint move: how far the tool point would go, and so how fast, is not known here.</source>
        <translation>以脉冲表示的目标只能通过关节移动到达：工具控制点移动多远、因而移动多快，在此未知。</translation>
    </message>
    <message>
        <source>This controller has a box, and where pulses lead is not known here: use the base frame.</source>
        <translation>此控制器设有范围框，而脉冲对应的位置在此未知：请使用基座坐标。</translation>
    </message>
</context>
<context>
    <name>names::Sentences</name>
    <message>
        <source>%1 has no signal #%2.</source>
        <translation>%1 没有信号 #%2。</translation>
    </message>
    <message>
        <source>There is no #%1: the last digit of a signal is 0 to 7.</source>
        <translation>没有 #%1：信号的末位为 0 至 7。</translation>
    </message>
    <message>
        <source>There is no %1#(%2): this controller has %1#(1) to %1#(%3).</source>
        <translation>没有 %1#(%2)：此控制器有 %1#(1) 至 %1#(%3)。</translation>
    </message>
    <message>
        <source>“%1” is not a signal. Write #00010, IN#(1) or OT#(1).</source>
        <translation>“%1”不是信号。请输入 #00010、IN#(1) 或 OT#(1)。</translation>
    </message>
</context>
<context>
    <name>pages::ActiveAlarmsCard</name>
    <message>
        <source>Active alarms</source>
        <translation>当前报警</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>全部确认</translation>
    </message>
    <message>
        <source>Acknowledging is noted on this computer only. The robot does not hear of it.</source>
        <translation>确认仅记录在本计算机上，不会通知机器人。</translation>
    </message>
    <message>
        <source>Choose one or more alarms in the table first.</source>
        <translation>请先在表中选择一个或多个报警。</translation>
    </message>
    <message>
        <source>Whether there is an alarm is not known now.</source>
        <translation>现在是否有报警未知。</translation>
    </message>
    <message>
        <source>There is no alarm to clear.</source>
        <translation>没有可复位的报警。</translation>
    </message>
    <message>
        <source>Clears the alarms whose causes are gone.</source>
        <translation>复位原因已消除的报警。</translation>
    </message>
    <message>
        <source>Clears, if the cause is gone: %1.</source>
        <translation>若原因已消除，则复位：%1。</translation>
    </message>
    <message>
        <source>Whether there is an error is not known now.</source>
        <translation>现在是否有错误未知。</translation>
    </message>
    <message>
        <source>Clears the error message at the pendant, and no alarm.</source>
        <translation>解除示教编程器上的错误信息，不复位报警。</translation>
    </message>
    <message>
        <source>There is no error to clear.</source>
        <translation>没有可解除的错误。</translation>
    </message>
    <message>
        <source>Not connected: nothing is known of the active alarms.</source>
        <translation>未连接：当前报警未知。</translation>
    </message>
    <message>
        <source>The alarms have not been read yet.</source>
        <translation>尚未读取报警。</translation>
    </message>
    <message>
        <source>The controller does not tell its alarms.</source>
        <translation>控制器不提供报警信息。</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) active when last seen.</source>
        <translation>
            <numerusform>最后读取时有 %n 个报警。</numerusform>
        </translation>
    </message>
    <message>
        <source>No alarm is active.</source>
        <translation>没有报警。</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) active, the newest first.</source>
        <translation>
            <numerusform>%n 个当前报警，最新的在前。</numerusform>
        </translation>
    </message>
    <message>
        <source>Reset accepted. Reading the alarms…</source>
        <translation>复位已接受。正在读取报警…</translation>
    </message>
    <message>
        <source>Reset accepted. Whether an alarm is left is not known: the status cannot be read.</source>
        <translation>复位已接受。是否仍有报警未知：无法读取状态。</translation>
    </message>
    <message>
        <source>Reset accepted. No alarm is active any more.</source>
        <translation>复位已接受。已没有报警。</translation>
    </message>
    <message>
        <source>▲ Accepted, still active: remove the cause first.</source>
        <translation>▲ 已接受，但报警仍在：请先消除原因。</translation>
    </message>
    <message>
        <source>▲ Accepted, still active: remove the cause first. Left are: %1.</source>
        <translation>▲ 已接受，但报警仍在：请先消除原因。剩余：%1。</translation>
    </message>
    <message>
        <source>Cancel error accepted.</source>
        <translation>解除错误已接受。</translation>
    </message>
</context>
<context>
    <name>pages::AlarmHistoryCard</name>
    <message>
        <source>History</source>
        <translation>履历</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Past alarms</source>
        <translation>过去的报警</translation>
    </message>
    <message>
        <source>Most frequent</source>
        <translation>最频繁</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>List</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>All lists</source>
        <translation>所有列表</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Search code, text or time</source>
        <translation>搜索代码、内容或时间</translation>
    </message>
    <message>
        <source>Most frequent alarms</source>
        <translation>最频繁的报警</translation>
    </message>
    <message>
        <source>Counted in everything this journal has of the controller. The times between are by the controller&apos;s clock; steps of that clock are left out.</source>
        <translation>统计范围为此日志中该控制器的全部记录。间隔时间按控制器的时钟计算；时钟调整造成的跳变不计入。</translation>
    </message>
    <message>
        <source>Note on %1</source>
        <translation>%1 的备注</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>停止读取</translation>
    </message>
    <message>
        <source>Read now</source>
        <translation>立即读取</translation>
    </message>
    <message numerus="yes">
        <source>Reading the history from the controller: %n entry(s) read.</source>
        <translation>
            <numerusform>正在从控制器读取履历：已读取 %n 条。</numerusform>
        </translation>
    </message>
    <message>
        <source>The journal cannot be read: %1.</source>
        <translation>无法读取日志：%1。</translation>
    </message>
    <message numerus="yes">
        <source>Reading was stopped. %n entry(s) in the journal.</source>
        <translation>
            <numerusform>读取已停止。日志中有 %n 条。</numerusform>
        </translation>
    </message>
    <message>
        <source>The history could not be read to its end: %1.</source>
        <translation>履历未能读取完：%1。</translation>
    </message>
    <message numerus="yes">
        <source>The newest %n entry(s) of the journal; the export has all of them.</source>
        <translation>
            <numerusform>日志中最新的 %n 条；导出时包含全部。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) in the journal, kept for ever.</source>
        <translation>
            <numerusform>日志中有 %n 条，永久保存。</numerusform>
        </translation>
    </message>
    <message>
        <source>Export past alarms</source>
        <translation>导出过去的报警</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) exported.</source>
        <translation>
            <numerusform>已导出 %n 条。</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>未导出：%1。</translation>
    </message>
</context>
<context>
    <name>pages::AlarmNotes</name>
    <message>
        <source>Save note</source>
        <translation>保存备注</translation>
    </message>
    <message>
        <source>Export notes…</source>
        <translation>导出备注…</translation>
    </message>
    <message numerus="yes">
        <source>%n note(s) exported.</source>
        <translation>
            <numerusform>已导出 %n 条备注。</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>未导出：%1。</translation>
    </message>
    <message>
        <source>Export notes</source>
        <translation>导出备注</translation>
    </message>
    <message>
        <source>Codes with a note</source>
        <translation>有备注的代码</translation>
    </message>
    <message>
        <source>Alarm code</source>
        <translation>报警代码</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>What we did</source>
        <translation>采取的措施</translation>
    </message>
    <message>
        <source>The notes cannot be read: %1.</source>
        <translation>无法读取备注：%1。</translation>
    </message>
    <message>
        <source>No note yet.</source>
        <translation>尚无备注。</translation>
    </message>
    <message>
        <source>Last changed by %1, %2.</source>
        <translation>最后修改：%1，%2。</translation>
    </message>
</context>
<context>
    <name>pages::AxesCard</name>
    <message>
        <source>pulses</source>
        <translation>脉冲</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>following error, pulses</source>
        <translation>跟随误差，脉冲</translation>
    </message>
    <message>
        <source>torque, raw</source>
        <translation>转矩，原始值</translation>
    </message>
    <message>
        <source>As the controller sends it: the unit is stated nowhere.</source>
        <translation>按控制器发送的原样显示：单位未见任何说明。</translation>
    </message>
    <message>
        <source>encoder, °C</source>
        <translation>编码器，°C</translation>
    </message>
    <message>
        <source>min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Converter %1: %2 °C</source>
        <translation>整流器 %1：%2 °C</translation>
    </message>
    <message>
        <source>Converter %1: %2 °C, last seen %3</source>
        <translation>整流器 %1：%2 °C，最后读取于 %3</translation>
    </message>
    <message>
        <source>Converter temperature: %1</source>
        <translation>整流器温度：%1</translation>
    </message>
</context>
<context>
    <name>pages::BackupPage</name>
    <message>
        <source>Backups</source>
        <translation>备份</translation>
    </message>
    <message>
        <source> newest</source>
        <translation> 个最新</translation>
    </message>
    <message>
        <source>Keep any number</source>
        <translation>保留数量不限</translation>
    </message>
    <message>
        <source> days</source>
        <translation> 天</translation>
    </message>
    <message>
        <source>Keep any age</source>
        <translation>保留时间不限</translation>
    </message>
    <message>
        <source>Back up now</source>
        <translation>立即备份</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>验证</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message numerus="yes">
        <source>Good: every byte of %n file(s) is as it was written.</source>
        <translation>
            <numerusform>完好：%n 个文件的每个字节都与写入时相同。</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ Not good: %1</source>
        <translation>▲ 不完好：%1</translation>
    </message>
    <message>
        <source>After a backup keep</source>
        <translation>备份后保留</translation>
    </message>
    <message>
        <source>The last good backup and pinned ones are never deleted.</source>
        <translation>最后一个完好的备份和已固定的备份绝不会被删除。</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>比较对象</translation>
    </message>
    <message>
        <source>with the backup before</source>
        <translation>与前一个备份</translation>
    </message>
    <message>
        <source>with the newest backup</source>
        <translation>与最新的备份</translation>
    </message>
    <message>
        <source>with the controller now</source>
        <translation>与当前的控制器</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translation>恢复…</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>位于 %1</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>取消固定</translation>
    </message>
    <message>
        <source>Choose a backup first.</source>
        <translation>请先选择一个备份。</translation>
    </message>
    <message>
        <source>Files are being read.</source>
        <translation>正在读取文件。</translation>
    </message>
    <message>
        <source>Reading file %1 of %2…</source>
        <translation>正在读取第 %1 个文件，共 %2 个…</translation>
    </message>
    <message>
        <source>Reading the lists…</source>
        <translation>正在读取列表…</translation>
    </message>
    <message>
        <source>▲ There is no new backup: %1</source>
        <translation>▲ 没有新的备份：%1</translation>
    </message>
    <message>
        <source>▲ %1 of %2 files were backed up.</source>
        <translation>▲ 已备份 %1 个文件，共 %2 个。</translation>
    </message>
    <message numerus="yes">
        <source>All %n file(s) were backed up.</source>
        <translation>
            <numerusform>全部 %n 个文件已备份。</numerusform>
        </translation>
    </message>
    <message>
        <source>Reading every byte…</source>
        <translation>正在读取每个字节…</translation>
    </message>
    <message>
        <source>There is no other backup to compare with.</source>
        <translation>没有可供比较的其他备份。</translation>
    </message>
    <message>
        <source>The controller&apos;s files were read.</source>
        <translation>已读取控制器的文件。</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>文件夹…</translation>
    </message>
    <message>
        <source>Folder of the backups</source>
        <translation>备份文件夹</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Exported.</source>
        <translation>已导出。</translation>
    </message>
    <message>
        <source>▲ Not exported: %1</source>
        <translation>▲ 未导出：%1</translation>
    </message>
    <message>
        <source>Export the backup</source>
        <translation>导出备份</translation>
    </message>
    <message>
        <source>Zip files (*.zip)</source>
        <translation>Zip 文件 (*.zip)</translation>
    </message>
    <message>
        <source>Exporting to %1…</source>
        <translation>正在导出到 %1…</translation>
    </message>
    <message>
        <source>the controller now</source>
        <translation>当前的控制器</translation>
    </message>
</context>
<context>
    <name>pages::CartesianCard</name>
    <message>
        <source>now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Tool point</source>
        <translation>工具控制点</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形态</translation>
    </message>
    <message>
        <source>Extended form</source>
        <translation>扩展形态</translation>
    </message>
    <message>
        <source>%1 · base frame, tool %2</source>
        <translation>%1 · 基座坐标，工具 %2</translation>
    </message>
    <message>
        <source>%1 · base frame</source>
        <translation>%1 · 基座坐标</translation>
    </message>
    <message>
        <source>%1 has no tool point: HSES tells it of robots only.</source>
        <translation>%1 没有工具控制点：HSES 仅提供机器人的工具控制点。</translation>
    </message>
    <message>
        <source>%1, base frame, tool %2</source>
        <translation>%1，基座坐标，工具 %2</translation>
    </message>
</context>
<context>
    <name>pages::ComparisonCard</name>
    <message>
        <source>≠ changed</source>
        <translation>≠ 已改变</translation>
    </message>
    <message>
        <source>+ new</source>
        <translation>+ 新增</translation>
    </message>
    <message>
        <source>− gone</source>
        <translation>− 已消失</translation>
    </message>
    <message>
        <source>▲ not read, nobody knows</source>
        <translation>▲ 未读取，情况未知</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>变化</translation>
    </message>
    <message>
        <source>Files that differ</source>
        <translation>有差异的文件</translation>
    </message>
    <message>
        <source>Choose a backup and compare it.</source>
        <translation>请选择一个备份并进行比较。</translation>
    </message>
    <message>
        <source>Not counted as a difference:</source>
        <translation>不计为差异：</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) differ</source>
        <translation>
            <numerusform>%n 个文件有差异</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a file above.</source>
        <translation>请在上方选择一个文件。</translation>
    </message>
    <message>
        <source>Nothing differs.</source>
        <translation>没有差异。</translation>
    </message>
    <message>
        <source>This file is not in the backup as it was written.</source>
        <translation>该文件在备份中与写入时不同。</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>不计入</translation>
    </message>
    <message>
        <source>Comparison: from %1 to %2</source>
        <translation>比较：从 %1 到 %2</translation>
    </message>
    <message>
        <source>The files are being compared…</source>
        <translation>正在比较文件…</translation>
    </message>
    <message numerus="yes">
        <source>Not counted: %n counter(s), log(s) and the like</source>
        <translation>
            <numerusform>不计入：%n 个计数器、日志等</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::CycleCard</name>
    <message>
        <source>Cycle</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>Actual</source>
        <translation>实际</translation>
    </message>
    <message>
        <source>Requested here</source>
        <translation>从此处请求</translation>
    </message>
    <message>
        <source>Nothing was requested from here.</source>
        <translation>未从此处请求过。</translation>
    </message>
    <message>
        <source>Cycle mode to request</source>
        <translation>要请求的循环模式</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>请求</translation>
    </message>
</context>
<context>
    <name>pages::FilePane</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n 个文件</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::FilesPage</name>
    <message>
        <source>This computer</source>
        <translation>本计算机</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>重新读取</translation>
    </message>
    <message>
        <source>← Fetch</source>
        <translation>← 获取</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>编辑…</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>文件夹…</translation>
    </message>
    <message>
        <source>Folder of the files</source>
        <translation>文件的文件夹</translation>
    </message>
    <message>
        <source>Type of the files</source>
        <translation>文件类型</translation>
    </message>
    <message>
        <source>Send →</source>
        <translation>发送 →</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>删除…</translation>
    </message>
    <message>
        <source>There are no controller files in this folder.</source>
        <translation>此文件夹中没有控制器文件。</translation>
    </message>
    <message>
        <source>Reading the list…</source>
        <translation>正在读取列表…</translation>
    </message>
    <message>
        <source>The controller lists no files of this type.</source>
        <translation>控制器没有列出此类型的文件。</translation>
    </message>
    <message>
        <source>Choose files on the left first.</source>
        <translation>请先在左侧选择文件。</translation>
    </message>
    <message>
        <source>Choose files on the right first.</source>
        <translation>请先在右侧选择文件。</translation>
    </message>
</context>
<context>
    <name>pages::FleetPage</name>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Size of the tiles</source>
        <translation>图块大小</translation>
    </message>
    <message>
        <source>HOLD ALL</source>
        <translation>全部 HOLD</translation>
    </message>
    <message>
        <source>HOLD all controllers (software)</source>
        <translation>HOLD 所有控制器（软件）</translation>
    </message>
    <message>
        <source>every station that is not off</source>
        <translation>所有未处于 OFF 的控制器</translation>
    </message>
    <message>
        <source>Connect all</source>
        <translation>全部连接</translation>
    </message>
    <message>
        <source>Back up all</source>
        <translation>全部备份</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>看板</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表格</translation>
    </message>
    <message>
        <source>S</source>
        <translation>小</translation>
    </message>
    <message>
        <source>M</source>
        <translation>中</translation>
    </message>
    <message>
        <source>L</source>
        <translation>大</translation>
    </message>
    <message>
        <source>Controllers</source>
        <translation>控制器</translation>
    </message>
    <message numerus="yes">
        <source>%n controller(s)</source>
        <translation>
            <numerusform>%n 台控制器</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n connected</source>
        <translation>
            <numerusform>%n 台已连接</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without link</source>
        <translation>
            <numerusform>%n 台无链路</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n station(s) that are not off</source>
        <translation>
            <numerusform>%n 台未处于 OFF 的控制器</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ HOLD was not confirmed by %1: look at the robot.</source>
        <translation>▲ %1 的 HOLD 未得到确认：请查看机器人。</translation>
    </message>
    <message>
        <source>HOLD is being asked of %1.</source>
        <translation>正在请求 %1 执行 HOLD。</translation>
    </message>
    <message numerus="yes">
        <source>HOLD was confirmed by %n controller(s).</source>
        <translation>
            <numerusform>%n 台控制器已确认 HOLD。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::GroupCard</name>
    <message>
        <source>axis %1</source>
        <translation>轴 %1</translation>
    </message>
</context>
<context>
    <name>pages::HoldCard</name>
    <message>
        <source>Hold</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>HOLD 来源</translation>
    </message>
</context>
<context>
    <name>pages::IoPage</name>
    <message>
        <source>User in</source>
        <translation>通用输入</translation>
    </message>
    <message>
        <source>User out</source>
        <translation>通用输出</translation>
    </message>
    <message>
        <source>External in</source>
        <translation>外部输入</translation>
    </message>
    <message>
        <source>Network in</source>
        <translation>网络输入</translation>
    </message>
    <message>
        <source>External out</source>
        <translation>外部输出</translation>
    </message>
    <message>
        <source>Network out</source>
        <translation>网络输出</translation>
    </message>
    <message>
        <source>System in</source>
        <translation>专用输入</translation>
    </message>
    <message>
        <source>System out</source>
        <translation>专用输出</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>接口面板</translation>
    </message>
    <message>
        <source>Relays</source>
        <translation>辅助继电器</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>控制状态</translation>
    </message>
    <message>
        <source>Pseudo in</source>
        <translation>伪输入</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Area of signals</source>
        <translation>信号区域</translation>
    </message>
    <message>
        <source>Watched signals</source>
        <translation>关注的信号</translation>
    </message>
    <message>
        <source>Count from 0</source>
        <translation>从 0 计数</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>关注</translation>
    </message>
    <message>
        <source>Over HSES only network inputs can be written: this lamp only shows.</source>
        <translation>通过 HSES 只能写入网络输入：此指示灯仅用于显示。</translation>
    </message>
    <message>
        <source>Write…</source>
        <translation>写入…</translation>
    </message>
    <message>
        <source>Name it here…</source>
        <translation>在本机命名…</translation>
    </message>
    <message>
        <source>Take the local name away</source>
        <translation>移除本机名称</translation>
    </message>
    <message>
        <source>Watch no longer</source>
        <translation>取消关注</translation>
    </message>
    <message>
        <source>Copy the address</source>
        <translation>复制地址</translation>
    </message>
    <message>
        <source>Edges are counted from what is read four times a second; shorter pulses are not seen.</source>
        <translation>边沿按每秒四次的读取结果计数；更短的脉冲检测不到。</translation>
    </message>
    <message>
        <source>Network inputs can be written: press Enter on a lamp.</source>
        <translation>网络输入可以写入：请在指示灯上按 Enter。</translation>
    </message>
    <message>
        <source>These lamps only show: over HSES only network inputs can be written.</source>
        <translation>这些指示灯仅用于显示：通过 HSES 只能写入网络输入。</translation>
    </message>
    <message numerus="yes">
        <source>%n group(s) from %1 on are refused: %2.</source>
        <translation>
            <numerusform>从 %1 起的 %n 组被拒绝：%2。</numerusform>
        </translation>
    </message>
    <message>
        <source>The controller&apos;s names are not known: %1.</source>
        <translation>控制器中的名称未知：%1。</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) of IONAME.DAT could not be read.</source>
        <translation>
            <numerusform>IONAME.DAT 有 %n 行无法读取。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::JobCard</name>
    <message>
        <source>master task</source>
        <translation>主任务</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>程序点</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>速度倍率</translation>
    </message>
</context>
<context>
    <name>pages::JobListCard</name>
    <message>
        <source>Jobs on the controller</source>
        <translation>控制器上的程序</translation>
    </message>
    <message>
        <source>★ Favourite</source>
        <translation>★ 收藏</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>重新读取</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Filter jobs by name</source>
        <translation>按名称筛选程序</translation>
    </message>
    <message>
        <source>The list could not be read: %1.</source>
        <translation>无法读取列表：%1。</translation>
    </message>
    <message>
        <source>Reading the list…</source>
        <translation>正在读取列表…</translation>
    </message>
    <message>
        <source>The list was not read yet.</source>
        <translation>列表尚未读取。</translation>
    </message>
    <message>
        <source>There is no job on the controller.</source>
        <translation>控制器上没有程序。</translation>
    </message>
    <message>
        <source>No job has “%1” in its name.</source>
        <translation>没有名称含“%1”的程序。</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>正在读取…</translation>
    </message>
    <message numerus="yes">
        <source>%n job(s)</source>
        <translation>
            <numerusform>%n 个程序</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, read at %2</source>
        <translation>%1，读取于 %2</translation>
    </message>
</context>
<context>
    <name>pages::JobTextCard</name>
    <message>
        <source>Job text</source>
        <translation>程序内容</translation>
    </message>
    <message>
        <source>Choose a job in the list to read it.</source>
        <translation>请在列表中选择一个程序以读取。</translation>
    </message>
    <message>
        <source>Follow what is executed</source>
        <translation>跟随执行</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>重新读取</translation>
    </message>
    <message>
        <source>Labels and calls</source>
        <translation>标号和调用</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <comment>line and label</comment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>正在读取…</translation>
    </message>
    <message>
        <source>read at %1</source>
        <translation>读取于 %1</translation>
    </message>
    <message>
        <source>The job could not be read: %1.</source>
        <translation>无法读取该程序：%1。</translation>
    </message>
    <message>
        <source>Read at %1. The controller was in TEACH or the link was lost since: this copy may be old.</source>
        <translation>读取于 %1。此后控制器曾处于 TEACH 或链路曾中断：此副本可能已过时。</translation>
    </message>
    <message>
        <source>Reading the job…</source>
        <translation>正在读取程序…</translation>
    </message>
    <message>
        <source>The job was not read yet.</source>
        <translation>尚未读取该程序。</translation>
    </message>
    <message>
        <source>This file holds no instructions that could be shown.</source>
        <translation>此文件中没有可显示的命令。</translation>
    </message>
</context>
<context>
    <name>pages::JobsPage</name>
    <message>
        <source>Orders</source>
        <translation>操作命令</translation>
    </message>
</context>
<context>
    <name>pages::JogCard</name>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步距</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Keyboard too: hold Ctrl and Space on the button that has the focus</source>
        <translation>也可用键盘：焦点在按钮上时按住 Ctrl 和空格键</translation>
    </message>
    <message>
        <source>Hold a button: one bounded step after another</source>
        <translation>按住按钮：逐步进行有限步距的移动</translation>
    </message>
    <message>
        <source>After a lost link</source>
        <translation>链路中断后</translation>
    </message>
    <message>
        <source>Last step</source>
        <translation>最后一步</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Axes (pulses)</source>
        <translation>轴（脉冲）</translation>
    </message>
    <message>
        <source>%1 mm · %2°</source>
        <translation>%1 mm · %2°</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 mm/s · %2 °/s</source>
        <translation>%1 mm/s · %2 °/s</translation>
    </message>
    <message>
        <source>at most one step: %1 pulses</source>
        <translation>最多一步：%1 脉冲</translation>
    </message>
    <message>
        <source>at most one step: %1 mm or %2°, in %3 s at most</source>
        <translation>最多一步：%1 mm 或 %2°，最长 %3 s</translation>
    </message>
    <message>
        <source>Off: the profile has a motion limit that is no number above 0 (%1).</source>
        <translation>不可用：配置中有一个运动限值不是大于 0 的数（%1）。</translation>
    </message>
    <message>
        <source>No answer to the step: whether it was taken is unknown. HOLD was sent. Look at the robot.</source>
        <translation>该步无应答：是否已执行未知。HOLD 已发送。请查看机器人。</translation>
    </message>
    <message>
        <source>Step sent…</source>
        <translation>步进已发送…</translation>
    </message>
    <message>
        <source>Moving…</source>
        <translation>移动中…</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s), at rest.</source>
        <translation>
            <numerusform>%n 步，已静止。</numerusform>
        </translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>尚无。</translation>
    </message>
</context>
<context>
    <name>pages::JournalPage</name>
    <message>
        <source>At any time</source>
        <translation>任何时间</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>今天</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>最近 7 天</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>最近 30 天</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>All controllers</source>
        <translation>所有控制器</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Any outcome</source>
        <translation>任何结果</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Search in all texts</source>
        <translation>搜索所有文本</translation>
    </message>
    <message>
        <source>Reading the journal…</source>
        <translation>正在读取日志…</translation>
    </message>
    <message>
        <source>The journal cannot be read: %1.</source>
        <translation>无法读取日志：%1。</translation>
    </message>
    <message>
        <source>Nothing was tried that fits this filter.</source>
        <translation>没有符合此筛选条件的操作。</translation>
    </message>
    <message numerus="yes">
        <source>The newest %n record(s). Scroll down for older ones.</source>
        <translation>
            <numerusform>最新的 %n 条记录。向下滚动可查看更早的记录。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n record(s)</source>
        <translation>
            <numerusform>%n 条记录</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a record to read all of it here.</source>
        <translation>请选择一条记录，在此查看全部内容。</translation>
    </message>
    <message>
        <source>%1: %2 at %3.</source>
        <translation>%1：%2，%3。</translation>
    </message>
    <message>
        <source>Outcome: %1.</source>
        <translation>结果：%1。</translation>
    </message>
    <message>
        <source>By %1 at %2, level %3.</source>
        <translation>操作者 %1，%2，级别 %3。</translation>
    </message>
    <message>
        <source>Export the journal</source>
        <translation>导出日志</translation>
    </message>
    <message numerus="yes">
        <source>%n record(s) exported.</source>
        <translation>
            <numerusform>已导出 %n 条记录。</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>未导出：%1。</translation>
    </message>
</context>
<context>
    <name>pages::LinkCard</name>
    <message>
        <source>%1 repeated</source>
        <translation>重发 %1</translation>
    </message>
    <message>
        <source>%1 unanswered</source>
        <translation>无应答 %1</translation>
    </message>
    <message>
        <source>%1 late</source>
        <translation>迟到 %1</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>重复 %1</translation>
    </message>
    <message>
        <source>%1 mismatched</source>
        <translation>不匹配 %1</translation>
    </message>
    <message>
        <source>%1 malformed</source>
        <translation>格式错误 %1</translation>
    </message>
    <message>
        <source>%1 from elsewhere</source>
        <translation>来自他处 %1</translation>
    </message>
    <message>
        <source>%1 busy</source>
        <translation>忙 %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>链路</translation>
    </message>
    <message>
        <source>last 60 s</source>
        <translation>最近 60 s</translation>
    </message>
    <message>
        <source>round trip p50 / p95</source>
        <translation>往返时间 p50 / p95</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>requests</source>
        <translation>请求</translation>
    </message>
    <message>
        <source>last answer</source>
        <translation>最后应答</translation>
    </message>
    <message>
        <source>sent / answered</source>
        <translation>发送 / 应答</translation>
    </message>
    <message>
        <source>unusual</source>
        <translation>异常情况</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 /s of %2</source>
        <translation>%1 /s，上限 %2</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>%1 前</translation>
    </message>
</context>
<context>
    <name>pages::MotionPage</name>
    <message>
        <source>Remote motion in automatic operation. The pendant’s enabling switch does not protect anyone here. Nobody may be inside the fence.</source>
        <translation>自动运行中的远程移动。示教编程器的使能开关（安全开关）在此不保护任何人。任何人不得在安全围栏内。</translation>
    </message>
    <message>
        <source>Before each step</source>
        <translation>每一步之前</translation>
    </message>
    <message>
        <source>Control group that moves</source>
        <translation>移动的控制轴组</translation>
    </message>
    <message>
        <source>Control group</source>
        <translation>控制轴组</translation>
    </message>
</context>
<context>
    <name>pages::MoveCard</name>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Type of the move</source>
        <translation>移动类型</translation>
    </message>
    <message>
        <source>Frame of the target</source>
        <translation>目标的坐标系</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>用户坐标</translation>
    </message>
    <message>
        <source>Base axes in mm</source>
        <translation>基座轴，mm</translation>
    </message>
    <message>
        <source>Rehearse…</source>
        <translation>预检…</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>Straight, increment</source>
        <translation>直线，增量</translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation>基座坐标</translation>
    </message>
    <message>
        <source>Robot frame</source>
        <translation>机器人坐标</translation>
    </message>
    <message>
        <source>Tool frame</source>
        <translation>工具坐标</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>脉冲</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>change</source>
        <translation>变化量</translation>
    </message>
    <message>
        <source>Speed in mm/s</source>
        <translation>速度，mm/s</translation>
    </message>
    <message>
        <source>Rotation speed in °/s</source>
        <translation>回转速度，°/s</translation>
    </message>
    <message>
        <source>Joint speed in %</source>
        <translation>关节速度，%</translation>
    </message>
    <message>
        <source>mm/s, at most %1</source>
        <translation>mm/s，最大 %1</translation>
    </message>
    <message>
        <source>°/s, at most %1</source>
        <translation>°/s，最大 %1</translation>
    </message>
    <message>
        <source>% of joint speed, at most %1</source>
        <translation>% 关节速度，最大 %1</translation>
    </message>
    <message>
        <source>Target of %1 in %2</source>
        <translation>%1 的目标（%2）</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis: reason</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>There are three base axes at most.</source>
        <translation>基座轴最多三个。</translation>
    </message>
    <message>
        <source>Base axes: %1</source>
        <translation>基座轴：%1</translation>
    </message>
    <message>
        <source>Off: the profile has a motion limit that is no number above 0 (%1).</source>
        <translation>不可用：配置中有一个运动限值不是大于 0 的数（%1）。</translation>
    </message>
    <message>
        <source>Form: %1</source>
        <translation>形态：%1</translation>
    </message>
</context>
<context>
    <name>pages::Offers</name>
    <message>
        <source>Before sending</source>
        <translation>发送之前</translation>
    </message>
    <message numerus="yes">
        <source>Send %n file(s)</source>
        <translation>
            <numerusform>发送 %n 个文件</numerusform>
        </translation>
    </message>
    <message>
        <source>on this computer</source>
        <translation>本计算机上</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>%1 上</translation>
    </message>
    <message>
        <source>What would change in “%1”</source>
        <translation>“%1”将有的变化</translation>
    </message>
</context>
<context>
    <name>pages::OptionsCard</name>
    <message>
        <source>always: the button above, the Pause key or Ctrl+Shift+H.</source>
        <translation>始终可用：上方的按钮、Pause 键或 Ctrl+Shift+H。</translation>
    </message>
    <message>
        <source>sent repeatedly until confirmed or 2 s have passed. Have the pendant at hand.</source>
        <translation>反复发送，直到得到确认或超过 2 s。请将示教编程器放在手边。</translation>
    </message>
    <message>
        <source>there is no connection: use the pendant.</source>
        <translation>没有连接：请使用示教编程器。</translation>
    </message>
    <message>
        <source>What can I do now?</source>
        <translation>现在可以做什么？</translation>
    </message>
    <message>
        <source>HOLD</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>possible</source>
        <translation>可以</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>不可以</translation>
    </message>
</context>
<context>
    <name>pages::PendantCard</name>
    <message>
        <source>Pendant</source>
        <translation>示教编程器</translation>
    </message>
    <message>
        <source>Message for the pendant</source>
        <translation>发给示教编程器的信息</translation>
    </message>
    <message>
        <source>Show on the pendant</source>
        <translation>在示教编程器上显示</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n byte(s)</source>
        <translation>
            <numerusform>%1 / %n 字节</numerusform>
        </translation>
    </message>
    <message>
        <source>Type a message first.</source>
        <translation>请先输入信息。</translation>
    </message>
    <message>
        <source>The controller&apos;s encoding cannot hold this: %1.</source>
        <translation>控制器的编码无法表示：%1。</translation>
    </message>
    <message>
        <source>The message is too long for the pendant.</source>
        <translation>信息过长，示教编程器无法显示。</translation>
    </message>
    <message>
        <source>HLOCK was switched on from here: the pendant is locked out, but for its emergency stop.</source>
        <translation>已从此处开启 HLOCK：示教编程器除急停外均被锁定。</translation>
    </message>
    <message>
        <source>HLOCK locks the pendant out. Whether it is on cannot be read over HSES; from here it was not switched on.</source>
        <translation>HLOCK 锁定示教编程器。HLOCK 是否开启无法通过 HSES 读取；未从此处开启过。</translation>
    </message>
</context>
<context>
    <name>pages::PointsBar</name>
    <message>
        <source>Take the present position</source>
        <translation>取当前位置</translation>
    </message>
    <message>
        <source>Take P</source>
        <translation>取 P</translation>
    </message>
    <message>
        <source>Earlier places</source>
        <translation>以前的位置</translation>
    </message>
    <message>
        <source>Keep the present position as P</source>
        <translation>将当前位置存为 P</translation>
    </message>
    <message>
        <source>P variable</source>
        <translation>P 变量</translation>
    </message>
    <message>
        <source>%1 is being read…</source>
        <translation>正在读取 %1…</translation>
    </message>
    <message>
        <source>%1 could not be read: %2.</source>
        <translation>无法读取 %1：%2。</translation>
    </message>
    <message>
        <source>%1 is in another frame (%2): choose that frame and an absolute move to take it.</source>
        <translation>%1 在另一坐标系（%2）中：要取用它，请选择该坐标系和绝对移动。</translation>
    </message>
    <message>
        <source>The target is %1.</source>
        <translation>目标为 %1。</translation>
    </message>
    <message>
        <source>Only the present position of a robot can be kept, once it was read.</source>
        <translation>只能保存机器人的当前位置，且须已读取。</translation>
    </message>
    <message>
        <source>%1 was written and read back.</source>
        <translation>%1 已写入并回读。</translation>
    </message>
    <message>
        <source>%1 was not verified: %2.</source>
        <translation>%1 未验证：%2。</translation>
    </message>
    <message>
        <source>%1 was written, but another value was read back.</source>
        <translation>%1 已写入，但回读到其他值。</translation>
    </message>
    <message>
        <source>No move has begun in this frame yet</source>
        <translation>在此坐标系下尚未开始过移动</translation>
    </message>
    <message>
        <source>%1 is not taught.</source>
        <translation>%1 未示教。</translation>
    </message>
    <message>
        <source>Other values are still being written.</source>
        <translation>仍在写入其他值。</translation>
    </message>
    <message>
        <source>%1 holds this position already.</source>
        <translation>%1 中已是此位置。</translation>
    </message>
</context>
<context>
    <name>pages::PositionCard</name>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>R1 · base frame, tool %1  ·  pulses</source>
        <translation>R1 · 基座坐标，工具 %1  ·  脉冲</translation>
    </message>
    <message>
        <source>R1 · base frame  ·  pulses</source>
        <translation>R1 · 基座坐标  ·  脉冲</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>轴 %1</translation>
    </message>
</context>
<context>
    <name>pages::PositionPage</name>
    <message>
        <source>Control groups</source>
        <translation>控制轴组</translation>
    </message>
    <message>
        <source>Reset min and max</source>
        <translation>重置最小和最大值</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>复制为文本</translation>
    </message>
    <message>
        <source>Not shown because refused: %1 of %2 control groups.</source>
        <translation>因被拒绝而未显示：%2 个控制轴组中的 %1 个。</translation>
    </message>
    <message numerus="yes">
        <source>%n control group(s)</source>
        <translation>
            <numerusform>%n 个控制轴组</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::QueueCard</name>
    <message>
        <source>Transfers</source>
        <translation>传输</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Retry failed</source>
        <translation>重试失败项</translation>
    </message>
    <message>
        <source>Clear finished</source>
        <translation>清除已完成项</translation>
    </message>
</context>
<context>
    <name>pages::RegistersPage</name>
    <message>
        <source>How registers are written</source>
        <translation>寄存器的显示格式</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>十进制</translation>
    </message>
    <message>
        <source>Signed</source>
        <translation>有符号</translation>
    </message>
    <message>
        <source>Hexadecimal</source>
        <translation>十六进制</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>二进制</translation>
    </message>
    <message>
        <source>M000 to M559 can be written; the others belong to the ladder.</source>
        <translation>M000 至 M559 可以写入；其余属于梯形图。</translation>
    </message>
</context>
<context>
    <name>pages::RemoteChanges</name>
    <message>
        <source>What changes in “%1” on %2</source>
        <translation>%2 上“%1”的变化</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>发送</translation>
    </message>
    <message>
        <source>Delete on %1</source>
        <translation>在 %1 上删除</translation>
    </message>
    <message>
        <source>These files are deleted on %1:
%2
Before that each is copied to %3.</source>
        <translation>将在 %1 上删除以下文件：
%2
删除之前，每个文件都会复制到 %3。</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n file(s)</source>
        <translation>
            <numerusform>删除 %n 个文件</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::SelectCard</name>
    <message>
        <source>Select</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>Select as</source>
        <translation>选择为</translation>
    </message>
    <message>
        <source>to be executed</source>
        <translation>执行程序</translation>
    </message>
    <message>
        <source>master job</source>
        <translation>主程序</translation>
    </message>
    <message>
        <source>master job of sub task %1</source>
        <translation>子任务 %1 的主程序</translation>
    </message>
    <message>
        <source>From line</source>
        <translation>起始行</translation>
    </message>
    <message>
        <source>line </source>
        <translation>行 </translation>
    </message>
    <message>
        <source>Select %1</source>
        <translation>选择 %1</translation>
    </message>
    <message>
        <source>Choose a job in the list first.</source>
        <translation>请先在列表中选择一个程序。</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1，行 %2</translation>
    </message>
    <message>
        <source>task %1</source>
        <translation>任务 %1</translation>
    </message>
</context>
<context>
    <name>pages::SelectionCard</name>
    <message>
        <source>Job</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Where it is</source>
        <translation>当前位置</translation>
    </message>
    <message>
        <source>master task</source>
        <translation>主任务</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
</context>
<context>
    <name>pages::ServoCard</name>
    <message>
        <source>Servo</source>
        <translation>伺服</translation>
    </message>
    <message>
        <source>Servo power</source>
        <translation>伺服电源</translation>
    </message>
    <message>
        <source>A job is running: servo off stops it at once.</source>
        <translation>程序正在运行：断开伺服会立即使其停止。</translation>
    </message>
    <message>
        <source>Servo on…</source>
        <translation>接通伺服…</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>接通伺服</translation>
    </message>
    <message>
        <source>Switch servo power on at %1?

The robot can move from then on. Nobody may be inside the fence.</source>
        <translation>接通 %1 的伺服电源？

此后机器人可能移动。任何人不得在安全围栏内。</translation>
    </message>
</context>
<context>
    <name>pages::StartCard</name>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Start…</source>
        <translation>启动…</translation>
    </message>
</context>
<context>
    <name>pages::StartPanel</name>
    <message>
        <source>Start</source>
        <translation>起始页</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>Nothing is read and nothing is shown. Connecting only reads: nothing is written, started or moved by it.</source>
        <translation>未读取任何内容，也未显示任何内容。连接仅进行读取：不会因此写入、启动或移动任何内容。</translation>
    </message>
    <message>
        <source>Connect to a controller…</source>
        <translation>连接到控制器…</translation>
    </message>
    <message>
        <source>A controller in your network</source>
        <translation>网络中的控制器</translation>
    </message>
    <message>
        <source>Enter its name or address. Pendesk checks step by step whether it answers, and says what is wrong where it does not.</source>
        <translation>请输入其名称或地址。Pendesk 逐步检查其是否应答；没有应答时，会指出问题所在。</translation>
    </message>
    <message>
        <source>No robot at hand</source>
        <translation>手边没有机器人</translation>
    </message>
    <message>
        <source>The demo brings a simulated controller in this program. Everything can be tried with it, and no robot moves.</source>
        <translation>演示在本软件中提供一台仿真控制器。可用它尝试所有功能，不会有机器人移动。</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>打开演示</translation>
    </message>
    <message>
        <source>Recent controllers</source>
        <translation>最近的控制器</translation>
    </message>
    <message>
        <source>Another controller…</source>
        <translation>其他控制器…</translation>
    </message>
</context>
<context>
    <name>pages::StateCard</name>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>伺服</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Hold · pendant</source>
        <translation>HOLD · 示教编程器</translation>
    </message>
    <message>
        <source>Hold · external</source>
        <translation>HOLD · 外部</translation>
    </message>
    <message>
        <source>Hold · command</source>
        <translation>HOLD · 命令</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>速度限制</translation>
    </message>
</context>
<context>
    <name>pages::SystemCard</name>
    <message>
        <source>System</source>
        <translation>系统</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>机型</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>软件</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the system information</source>
        <translation>复制系统信息</translation>
    </message>
    <message>
        <source>The profile says %1, but this is the software of a %2: correct the profile.</source>
        <translation>配置中为 %1，但这是 %2 的软件：请更正配置。</translation>
    </message>
</context>
<context>
    <name>pages::TasksCard</name>
    <message>
        <source>Tasks</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Show the sub tasks</source>
        <translation>显示子任务</translation>
    </message>
    <message numerus="yes">
        <source>%n sub task(s)</source>
        <translation>
            <numerusform>%n 个子任务</numerusform>
        </translation>
    </message>
    <message>
        <source>Sub task %1</source>
        <translation>子任务 %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>pages::TileDelegate</name>
    <message>
        <source>ARMED</source>
        <translation>已激活</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>NOT CONNECTED</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>自 %1 起</translation>
    </message>
    <message>
        <source>last seen: %1</source>
        <translation>最后读取：%1</translation>
    </message>
    <message>
        <source>Servo %1</source>
        <translation>伺服 %1</translation>
    </message>
</context>
<context>
    <name>pages::Timeline</name>
    <message>
        <source>▲ no backup any more</source>
        <translation>▲ 已不是备份</translation>
    </message>
    <message numerus="yes">
        <source>▲ %n file(s) missing</source>
        <translation>
            <numerusform>▲ 缺少 %n 个文件</numerusform>
        </translation>
    </message>
    <message>
        <source>complete</source>
        <translation>完整</translation>
    </message>
    <message>
        <source>%1, pinned</source>
        <translation>%1，已固定</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>备份时间</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>Changed</source>
        <comment>number of files</comment>
        <translation>已改变</translation>
    </message>
</context>
<context>
    <name>pages::ToolPathCard</name>
    <message>
        <source>Tool path</source>
        <translation>工具轨迹</translation>
    </message>
    <message>
        <source>Clear path</source>
        <translation>清除轨迹</translation>
    </message>
    <message>
        <source>%1 · base frame</source>
        <translation>%1 · 基座坐标</translation>
    </message>
    <message>
        <source>%1 has no tool point: HSES tells it of robots only.</source>
        <translation>%1 没有工具控制点：HSES 仅提供机器人的工具控制点。</translation>
    </message>
</context>
<context>
    <name>pages::TrendPage</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Add signal…</source>
        <translation>添加信号…</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>导出 CSV…</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Freezes the view; recording goes on.</source>
        <translation>冻结视图；记录继续进行。</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>返回实时</translation>
    </message>
    <message>
        <source>Time in view</source>
        <translation>视图时间范围</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>趋势</translation>
    </message>
    <message>
        <source>Nothing is plotted yet. Drag a number here from any page, choose “Add to trend” in its menu, or add a signal.</source>
        <translation>尚未绘制任何曲线。请从任意页面将数值拖到此处，在其菜单中选择“添加到趋势”，或添加信号。</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Remove from trend</source>
        <translation>从趋势中移除</translation>
    </message>
    <message>
        <source>Incidents</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>60 s before an alarm, 20 s after</source>
        <translation>报警前 60 s，报警后 20 s</translation>
    </message>
    <message>
        <source>Open incident</source>
        <translation>打开事件</translation>
    </message>
    <message>
        <source>No alarm has been recorded yet.</source>
        <translation>尚未记录到报警。</translation>
    </message>
    <message>
        <source>It could not be saved: %1</source>
        <translation>无法保存：%1</translation>
    </message>
    <message>
        <source>Incident of %1: %2</source>
        <translation>%1 的事件：%2</translation>
    </message>
    <message>
        <source>Paused at %1; recording goes on</source>
        <translation>已于 %1 暂停；记录继续进行</translation>
    </message>
    <message>
        <source>Nothing is recorded: no communication</source>
        <translation>没有记录：无通信</translation>
    </message>
    <message>
        <source>Live; values of %1</source>
        <translation>实时；%1 的值</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>%1 is refused by the controller.</source>
        <translation>%1 被控制器拒绝。</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>This incident cannot be read: %1</source>
        <translation>无法读取此事件：%1</translation>
    </message>
    <message>
        <source>Export what is in view</source>
        <translation>导出视图内容</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSV 文件 (*.csv)</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>无法写入文件：%1</translation>
    </message>
</context>
<context>
    <name>pages::VariableSheet</name>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Undo last</source>
        <translation>撤销上次</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>寄存器</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>导入…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>%1 can only be read over HSES.</source>
        <translation>%1 通过 HSES 只能读取。</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>正在写入…</translation>
    </message>
    <message numerus="yes">
        <source>Apply %n…</source>
        <translation>
            <numerusform>应用 %n 个…</numerusform>
        </translation>
    </message>
    <message>
        <source>The values are being written.</source>
        <translation>正在写入这些值。</translation>
    </message>
    <message>
        <source>Nothing is staged: press Enter in a value.</source>
        <translation>没有暂存的值：请在某个值上按 Enter。</translation>
    </message>
    <message>
        <source>Nothing is staged.</source>
        <translation>没有暂存的值。</translation>
    </message>
    <message>
        <source>Stages the values that stood there before.</source>
        <translation>暂存写入之前的值。</translation>
    </message>
    <message>
        <source>Nothing was written that could be undone.</source>
        <translation>没有可撤销的写入。</translation>
    </message>
    <message>
        <source>Import values</source>
        <translation>导入值</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSV 文件 (*.csv)</translation>
    </message>
    <message>
        <source>Export values</source>
        <translation>导出值</translation>
    </message>
    <message>
        <source>%1 stays as it is: %2</source>
        <comment>variable: reason</comment>
        <translation>%1 保持不变：%2</translation>
    </message>
</context>
<context>
    <name>pages::VariableTransfer</name>
    <message>
        <source>%1 was written.</source>
        <translation>%1 已写入。</translation>
    </message>
    <message numerus="yes">
        <source>Reading %n variable(s)…</source>
        <translation>
            <numerusform>正在读取 %n 个变量…</numerusform>
        </translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>无法读取文件：%1</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>无法写入文件：%1</translation>
    </message>
</context>
<context>
    <name>pages::VariablesPage</name>
    <message>
        <source>Verify…</source>
        <translation>验证…</translation>
    </message>
    <message>
        <source>Kind of variable</source>
        <translation>变量种类</translation>
    </message>
    <message>
        <source>Compares two variables with the pendant. It only reads.</source>
        <translation>将两个变量与示教编程器比较。仅进行读取。</translation>
    </message>
    <message>
        <source>New watch page…</source>
        <translation>新建关注页…</translation>
    </message>
    <message>
        <source>New watch page</source>
        <translation>新建关注页</translation>
    </message>
    <message>
        <source>Name of the page</source>
        <translation>页面名称</translation>
    </message>
    <message>
        <source>Watch: %1</source>
        <translation>关注：%1</translation>
    </message>
    <message>
        <source>Delete this watch page</source>
        <translation>删除此关注页</translation>
    </message>
    <message>
        <source>Show on the watch page “%1”</source>
        <translation>在关注页“%1”上显示</translation>
    </message>
    <message>
        <source>Take off this watch page</source>
        <translation>从此关注页移除</translation>
    </message>
    <message>
        <source>There is no watch page yet.</source>
        <translation>尚无关注页。</translation>
    </message>
    <message>
        <source>Numbering not verified: nothing is written before it was compared with the pendant.</source>
        <translation>编号未验证：与示教编程器比较之前，不写入任何内容。</translation>
    </message>
    <message>
        <source>Simulation: number %1 on the network is B000.</source>
        <translation>仿真：网络编号 %1 为 B000。</translation>
    </message>
    <message>
        <source>Numbering verified %1: number %2 on the network is B000.</source>
        <translation>编号已验证 %1：网络编号 %2 为 B000。</translation>
    </message>
</context>
<context>
    <name>pages::start::RecentTile</name>
    <message>
        <source>no connection noted yet</source>
        <translation>尚无连接记录</translation>
    </message>
    <message>
        <source>connected today %1</source>
        <comment>the time</comment>
        <translation>今天 %1 连接过</translation>
    </message>
    <message>
        <source>connected yesterday %1</source>
        <comment>the time</comment>
        <translation>昨天 %1 连接过</translation>
    </message>
    <message>
        <source>connected %1 %2</source>
        <comment>the date, the time</comment>
        <translation>%1 %2 连接过</translation>
    </message>
    <message>
        <source>Connect to %1</source>
        <translation>连接到 %1</translation>
    </message>
    <message>
        <source>simulation</source>
        <translation>仿真</translation>
    </message>
</context>
<context>
    <name>pages::start::SetupCard</name>
    <message>
        <source>What must be set on the pendant</source>
        <translation>必须在示教编程器上设定的内容</translation>
    </message>
    <message>
        <source>Menus differ by model and software</source>
        <translation>菜单因机型和软件而异</translation>
    </message>
    <message>
        <source>To be found</source>
        <translation>可被找到</translation>
    </message>
    <message>
        <source>The Ethernet server function (HSES) is on; it is an option of DX100, DX200 and FS100. The controller has an IPv4 address in the network of this computer, and no firewall between them drops UDP %1 and %2.</source>
        <translation>以太网服务器功能 (HSES) 已启用；它是 DX100、DX200 和 FS100 的选项。控制器在本计算机所在的网络中有 IPv4 地址，且两者之间没有防火墙丢弃 UDP %1 和 %2。</translation>
    </message>
    <message>
        <source>To take orders</source>
        <translation>可接受命令</translation>
    </message>
    <message>
        <source>Only for starting, moving, resetting and files, not for reading: %1.</source>
        <translation>仅启动、移动、复位和文件操作需要，读取不需要：%1。</translation>
    </message>
    <message>
        <source>To select and replace</source>
        <translation>可选择和替换</translation>
    </message>
    <message>
        <source>For selecting jobs from here: %1. For replacing files that exist there: %2.</source>
        <translation>若要从此处选择程序：%1。若要替换控制器上已有的文件：%2。</translation>
    </message>
</context>
<context>
    <name>pendesk</name>
    <message>
        <source>A teach and monitor desk for Yaskawa robot controllers.</source>
        <translation>安川机器人控制器的示教和监视软件。</translation>
    </message>
    <message>
        <source>Connect to a simulated controller inside the program.</source>
        <translation>连接到软件内部的仿真控制器。</translation>
    </message>
    <message>
        <source>light, dark, or auto for the desktop&apos;s choice.</source>
        <translation>light、dark，或 auto（按桌面设置）。</translation>
    </message>
    <message>
        <source>Language of the window, as a code such as de; the desktop&apos;s unless told otherwise.</source>
        <translation>窗口的语言，用代码表示，例如 de；未指定时按桌面设置。</translation>
    </message>
    <message>
        <source>Allow watching, HOLD and servo off alone, whatever the person at the desk tries.</source>
        <translation>无论操作者尝试什么，只允许监视、HOLD 和断开伺服。</translation>
    </message>
    <message>
        <source>Write pictures of every page to this folder, print the status read, and end.</source>
        <translation>将每个页面的图片写入此文件夹，输出读取到的状态，然后结束。</translation>
    </message>
    <message>
        <source>Print when the window was painted and when the first status was live.</source>
        <translation>输出窗口绘制完成和首次读到实时状态的时间。</translation>
    </message>
    <message>
        <source>--demo brings its own controller: leave out --host and --profile.</source>
        <translation>--demo 自带控制器：不要使用 --host 和 --profile。</translation>
    </message>
    <message>
        <source>--theme must be light, dark or auto.</source>
        <translation>--theme 必须是 light、dark 或 auto。</translation>
    </message>
    <message>
        <source>--language must be one of: %1.</source>
        <translation>--language 必须是以下之一：%1。</translation>
    </message>
    <message>
        <source>“%1” is not an option.</source>
        <translation>“%1”不是选项。</translation>
    </message>
    <message>
        <source>--pictures needs a folder, and --demo, --host or --profile.</source>
        <translation>--pictures 需要一个文件夹，以及 --demo、--host 或 --profile。</translation>
    </message>
    <message>
        <source>Write one picture of all pages, light and dark, in English, German and Japanese, and end.</source>
        <translation>将所有页面的浅色和深色显示，以英语、德语和日语写成一张图片，然后结束。</translation>
    </message>
    <message>
        <source>--contact-sheet needs a file, and --demo, --host or --profile.</source>
        <translation>--contact-sheet 需要一个文件，以及 --demo、--host 或 --profile。</translation>
    </message>
</context>
<context>
    <name>pendesk::Pictures</name>
    <message>
        <source>not everything was read</source>
        <translation>未能读取全部内容</translation>
    </message>
    <message>
        <source>pendesk: %1 cannot be written.</source>
        <translation>pendesk：无法写入 %1。</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>机型</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>软件</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>伺服</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Executing</source>
        <translation>执行中</translation>
    </message>
    <message>
        <source>Pictures are in %1</source>
        <translation>图片位于 %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>无法创建文件夹 %1</translation>
    </message>
    <message>
        <source>no live controller within 5 s: %1</source>
        <translation>5 s 内没有实时的控制器：%1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>无法写入 %1</translation>
    </message>
    <message>
        <source>pendesk: %1.</source>
        <translation>pendesk：%1。</translation>
    </message>
</context>
<context>
    <name>pendeskctl</name>
    <message>
        <source>It stopped at %1. As it was it is in %2; “restore” that one with this name puts it back.</source>
        <translation>停止于 %1。其之前的内容在 %2 中；对该备份使用此名称执行“restore”可将其放回。</translation>
    </message>
    <message>
        <source>Delete all but the newest N backups afterwards, never the last good one.</source>
        <translation>之后仅保留最新的 N 个备份，其余删除；绝不删除最后一个完好的备份。</translation>
    </message>
    <message>
        <source>Delete backups older than N days afterwards, never the last good one.</source>
        <translation>之后删除早于 N 天的备份；绝不删除最后一个完好的备份。</translation>
    </message>
    <message>
        <source>Reads all files of the controller into DIR/&lt;controller&gt;/&lt;UTC time&gt;, in BagIt form.</source>
        <translation>以 BagIt 格式将控制器的所有文件读取到 DIR/&lt;controller&gt;/&lt;UTC time&gt;。</translation>
    </message>
    <message>
        <source>Reads a backup and tells whether it is what was written.</source>
        <translation>读取备份，并说明其是否与写入时相同。</translation>
    </message>
    <message>
        <source>Only print what would be done.</source>
        <translation>仅输出将执行的操作。</translation>
    </message>
    <message>
        <source>The backup is not as it was written; “verify” tells what is wrong. Nothing was done with it.</source>
        <translation>该备份与写入时不同；“verify”会说明问题所在。未对该备份执行任何操作。</translation>
    </message>
    <message>
        <source>“%1” is no file name.</source>
        <translation>“%1”不是文件名。</translation>
    </message>
    <message>
        <source>Print for people instead of JSON.</source>
        <translation>以便于阅读的形式输出，而不是 JSON。</translation>
    </message>
    <message>
        <source>The request that a reply answers.</source>
        <translation>应答所对应的请求。</translation>
    </message>
    <message>
        <source>The port of the packets: 10040 or 10041.</source>
        <translation>数据包的端口：10040 或 10041。</translation>
    </message>
    <message>
        <source>A packet; without any, one a line on stdin.</source>
        <translation>一个数据包；未指定时，从 stdin 每行读取一个。</translation>
    </message>
    <message>
        <source>A job is running; files are not changed meanwhile.</source>
        <translation>有程序正在运行；期间不更改文件。</translation>
    </message>
    <message>
        <source>The name “%1” has no IPv4 address.</source>
        <translation>名称“%1”没有 IPv4 地址。</translation>
    </message>
    <message>
        <source>The folder “%1” cannot be made.</source>
        <translation>无法创建文件夹“%1”。</translation>
    </message>
    <message>
        <source>%1 exists and is left alone; --yes replaces it.</source>
        <translation>%1 已存在，不改动；使用 --yes 可替换。</translation>
    </message>
    <message>
        <source>“%1” is no name that a controller takes.</source>
        <translation>“%1”不是控制器可接受的名称。</translation>
    </message>
    <message>
        <source>%1 exists at the controller and is left alone; --replace replaces it.</source>
        <translation>%1 在控制器上已存在，不改动；使用 --replace 可替换。</translation>
    </message>
    <message>
        <source>Lists the jobs.</source>
        <translation>列出程序。</translation>
    </message>
    <message>
        <source>The folder for what comes; for rm, for the copies.</source>
        <translation>存放获取的文件的文件夹；对于 rm，存放副本的文件夹。</translation>
    </message>
    <message>
        <source>put: replace what the controller has.</source>
        <translation>put：替换控制器上已有的文件。</translation>
    </message>
    <message>
        <source>Say “ls”, “get NAME…”, “put FILE…” or “rm NAME…”.</source>
        <translation>请指定“ls”、“get NAME…”、“put FILE…”或“rm NAME…”。</translation>
    </message>
    <message>
        <source>read status, job, position and system information</source>
        <translation>读取状态、程序、位置和系统信息</translation>
    </message>
    <message>
        <source>read model, system software and parameter version</source>
        <translation>读取机型、系统软件和参数版本</translation>
    </message>
    <message>
        <source>read the active alarms, or a list of the history</source>
        <translation>读取当前报警，或履历中的列表</translation>
    </message>
    <message>
        <source>read where the robot stands</source>
        <translation>读取机器人的位置</translation>
    </message>
    <message>
        <source>list the jobs</source>
        <translation>列出程序</translation>
    </message>
    <message>
        <source>read I/O, write a network input</source>
        <translation>读取 I/O，写入网络输入</translation>
    </message>
    <message>
        <source>read and write registers</source>
        <translation>读取和写入寄存器</translation>
    </message>
    <message>
        <source>read and write variables</source>
        <translation>读取和写入变量</translation>
    </message>
    <message>
        <source>list, read, send and delete files</source>
        <translation>列出、读取、发送和删除文件</translation>
    </message>
    <message>
        <source>read all files of a controller into a new backup</source>
        <translation>将控制器的所有文件读取到新的备份</translation>
    </message>
    <message>
        <source>tell whether a backup is what was written</source>
        <translation>说明备份是否与写入时相同</translation>
    </message>
    <message>
        <source>compare two backups, or one with the controller</source>
        <translation>比较两个备份，或将一个备份与控制器比较</translation>
    </message>
    <message>
        <source>send back what differs from a backup</source>
        <translation>发回与备份不同的内容</translation>
    </message>
    <message>
        <source>read values again and again</source>
        <translation>反复读取值</translation>
    </message>
    <message>
        <source>take packets given in hex apart</source>
        <translation>解析以十六进制给出的数据包</translation>
    </message>
    <message>
        <source>Usage: pendeskctl VERB [options]</source>
        <translation>用法：pendeskctl VERB [options]</translation>
    </message>
    <message>
        <source>pendeskctl VERB --help tells more.</source>
        <translation>pendeskctl VERB --help 显示更多说明。</translation>
    </message>
    <message>
        <source>there is no verb “%1”.</source>
        <translation>没有动词“%1”。</translation>
    </message>
    <message>
        <source>%1: the controller has no such row of I/O groups.</source>
        <translation>%1：控制器没有这一行 I/O 组。</translation>
    </message>
    <message>
        <source>Instance of the first variable on this controller, 0 or 1 (parameter RS022).</source>
        <translation>此控制器上第一个变量的实例号，0 或 1（参数 RS022）。</translation>
    </message>
    <message>
        <source>Print JSON.</source>
        <translation>输出 JSON。</translation>
    </message>
    <message>
        <source>Yes, write: what changes something does nothing without it.</source>
        <translation>是，写入：不带此选项时，任何会造成更改的命令都不执行。</translation>
    </message>
    <message>
        <source>No progress and no remarks.</source>
        <translation>不显示进度和提示。</translation>
    </message>
    <message>
        <source>--numbering takes 0 or 1.</source>
        <translation>--numbering 的值为 0 或 1。</translation>
    </message>
    <message>
        <source>Name the controller with --host or --profile.</source>
        <translation>请用 --host 或 --profile 指定控制器。</translation>
    </message>
    <message>
        <source>See pendeskctl %1 --help.</source>
        <translation>请参阅 pendeskctl %1 --help。</translation>
    </message>
    <message>
        <source>This changes something at the controller or on this computer. Add --yes to do it.</source>
        <translation>这会更改控制器或本计算机上的内容。要执行，请加上 --yes。</translation>
    </message>
    <message>
        <source>Say what to read.</source>
        <translation>请指定要读取的内容。</translation>
    </message>
    <message>
        <source>Positions are not written from the command line.</source>
        <translation>位置不能从命令行写入。</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>无法写入 %1。</translation>
    </message>
    <message>
        <source>Nobody has verified which instance a variable has on this controller. Compare one value with the pendant, then say --numbering 0 or --numbering 1.</source>
        <translation>尚未验证变量在此控制器上的实例号。请将一个值与示教编程器比较，然后指定 --numbering 0 或 --numbering 1。</translation>
    </message>
    <message>
        <source>Another value was read back: %1</source>
        <translation>回读到其他值：%1</translation>
    </message>
    <message>
        <source>io set takes one signal, such as 27010, and 0 or 1.</source>
        <translation>io set 需要一个信号（例如 27010）以及 0 或 1。</translation>
    </message>
    <message>
        <source>%1 cannot be written: HSES writes network inputs alone.</source>
        <translation>无法写入 %1：HSES 只能写入网络输入。</translation>
    </message>
    <message>
        <source>Say “get NAME…” or “set NAME VALUE”.</source>
        <translation>请指定“get NAME…”或“set NAME VALUE”。</translation>
    </message>
    <message>
        <source>Reads model, system software and parameter version.</source>
        <translation>读取机型、系统软件和参数版本。</translation>
    </message>
    <message>
        <source>In pulses instead of the base frame.</source>
        <translation>以脉冲表示，而不是基座坐标。</translation>
    </message>
    <message>
        <source>A list of the history instead: major, minor, user, system or offline.</source>
        <translation>改为读取履历中的列表：major、minor、user、system 或 offline。</translation>
    </message>
    <message>
        <source>Reads the active alarms, newest first.</source>
        <translation>读取当前报警，最新的在前。</translation>
    </message>
    <message>
        <source>--history takes major, minor, user, system or offline.</source>
        <translation>--history 的值为 major、minor、user、system 或 offline。</translation>
    </message>
    <message>
        <source>Reads rows of I/O groups (2701..2710) or signals (27010, IN#(1)); writes one network input.</source>
        <translation>读取 I/O 组的行（2701..2710）或信号（27010、IN#(1)）；写入一个网络输入。</translation>
    </message>
    <message>
        <source>Reads registers; writes one and reads it back.</source>
        <translation>读取寄存器；写入一个并回读。</translation>
    </message>
    <message>
        <source>Reads variables B I D R S P BP EX; writes one and reads it back.</source>
        <translation>读取变量 B I D R S P BP EX；写入一个并回读。</translation>
    </message>
    <message>
        <source>Time between two readings: 1s, 200ms.</source>
        <translation>两次读取的间隔时间：1s、200ms。</translation>
    </message>
    <message>
        <source>End after so many readings.</source>
        <translation>读取指定次数后结束。</translation>
    </message>
    <message>
        <source>Reads variables, registers (M005) and I/O again and again, one line of JSON with --json.</source>
        <translation>反复读取变量、寄存器（M005）和 I/O；使用 --json 时每次输出一行 JSON。</translation>
    </message>
    <message>
        <source>Reads status, executing job, position and system information once.</source>
        <translation>读取一次状态、执行中的程序、位置和系统信息。</translation>
    </message>
    <message>
        <source>Lists, reads, sends and deletes files. Sent files are read back; before a file is deleted, a copy is written here. What exists is replaced by get with --yes, by put with --replace; put and rm need --yes.</source>
        <translation>列出、读取、发送和删除文件。发送的文件会被读回；删除文件之前会在此处写入副本。已存在的文件：get 加 --yes 时替换，put 加 --replace 时替换；put 和 rm 需要 --yes。</translation>
    </message>
    <message>
        <source>The controller lists no file that “%1” matches.</source>
        <translation>控制器的列表中没有与“%1”匹配的文件。</translation>
    </message>
    <message>
        <source>The controller is named with --host H, or with --profile NAME as Pendesk keeps it.</source>
        <translation>用 --host H 指定控制器，或用 --profile NAME 指定 Pendesk 中保存的控制器。</translation>
    </message>
    <message>
        <source>What changes something does nothing without --yes.</source>
        <translation>会作出更改的操作在没有 --yes 时不执行任何动作。</translation>
    </message>
    <message>
        <source>Exit codes: 0 done, 1 differences, 2 wrong call, 3 no answer or outcome unknown, 4 refused,
5 local file error, 6 verification failed, 7 done in part.</source>
        <translation>退出码：0 完成，1 有差异，2 调用错误，3 无应答或结果未知，4 被拒绝，
5 本地文件错误，6 校验未通过，7 部分完成。</translation>
    </message>
    <message>
        <source>Nobody has verified how this controller numbers its variables (parameter RS022), so these may be their neighbours. --numbering 0 or --numbering 1 settles it.</source>
        <translation>尚未有人核实该控制器如何为变量编号（参数 RS022），因此这些可能是相邻的变量。用 --numbering 0 或 --numbering 1 确定。</translation>
    </message>
    <message>
        <source>Print this and end.</source>
        <translation>打印此内容并结束。</translation>
    </message>
    <message>
        <source>Files restored: %1. The fresh backup is %2.</source>
        <translation>已恢复的文件：%1。新的备份为 %2。</translation>
    </message>
    <message>
        <source>The software of the controller is another than that with which the numbering was verified. Verify it again, or say --numbering 0 or --numbering 1.</source>
        <translation>控制器的软件与核实编号时的软件不同。请重新核实，或指定 --numbering 0 或 --numbering 1。</translation>
    </message>
    <message>
        <source>Also read ALL.PRM, which repeats the other parameter files and takes a real controller 45 s.</source>
        <translation>同时读取 ALL.PRM；它重复其他参数文件的内容，在实际控制器上需要 45 s。</translation>
    </message>
    <message>
        <source>The encoding of texts, such as Shift_JIS.</source>
        <translation>文本的编码，例如 Shift_JIS。</translation>
    </message>
    <message>
        <source>Looks at jobs as before they are sent, and prints what is wrong or odd; exit code 1 if a controller would refuse one.</source>
        <translation>按发送前的方式检查程序，并输出错误或异常之处；如果控制器会拒绝其中某个程序，退出码为 1。</translation>
    </message>
    <message>
        <source>Say the files or a folder.</source>
        <translation>请指定文件或文件夹。</translation>
    </message>
    <message>
        <source>“%1” is no encoding.</source>
        <translation>“%1”不是编码。</translation>
    </message>
    <message>
        <source>Not counted: %1 counters, %2 logs, %3 other files with nothing but dates, hours or check lines.</source>
        <translation>不计入：%1 个计数器、%2 个日志、%3 个仅含日期、时间或校验行的其他文件。</translation>
    </message>
    <message>
        <source>Count dates, counters, logs, blanks and line ends as differences too.</source>
        <translation>将日期、计数器、日志、空格和行尾也计为差异。</translation>
    </message>
    <message>
        <source>Compares two backups or folders of controller files, or one with the controller, in words; exit code 1 if configuration or data differ.</source>
        <translation>比较两个备份或控制器文件的文件夹，或将其中之一与控制器比较，并以文字说明；配置或数据有差异时退出码为 1。</translation>
    </message>
    <message>
        <source>The encoding of texts: %1.</source>
        <translation>文本的编码：%1。</translation>
    </message>
    <message>
        <source>The controller model: %1.</source>
        <translation>控制器机型：%1。</translation>
    </message>
    <message>
        <source>look at jobs before they are sent</source>
        <translation>在发送程序之前进行检查</translation>
    </message>
    <message>
        <source>tell what controller files say</source>
        <translation>说明控制器文件的内容</translation>
    </message>
    <message>
        <source>The encoding of the pendant&apos;s language instead of the stored one: %1.</source>
        <translation>使用示教编程器语言的编码，代替已保存的编码：%1。</translation>
    </message>
    <message>
        <source>--encoding takes one of %1.</source>
        <translation>--encoding 的值为以下之一：%1。</translation>
    </message>
    <message>
        <source>--%1 takes a whole number that is not negative.</source>
        <translation>--%1 的值为非负整数。</translation>
    </message>
    <message>
        <source>%1 does not take “%2”. See pendeskctl %1 --help.</source>
        <translation>%1 不接受“%2”。请参阅 pendeskctl %1 --help。</translation>
    </message>
    <message>
        <source>%1 takes %2. See pendeskctl %1 --help.</source>
        <translation>%1 需要 %2。请参阅 pendeskctl %1 --help。</translation>
    </message>
    <message>
        <source>Reads where a control group stands: the first robot, or R2, B1, S1.</source>
        <translation>读取控制轴组的位置：第一个机器人，或 R2、B1、S1。</translation>
    </message>
    <message>
        <source>“%1” is no control group of a %2: say R1, B1 or S1.</source>
        <translation>“%1”不是 %2 的控制轴组：请指定 R1、B1 或 S1。</translation>
    </message>
    <message>
        <source>The backup (left) is of another robot than the controller (right). Nothing was sent. Single jobs and names can be sent by their names.</source>
        <translation>备份（左）与控制器（右）不是同一台机器人。未发送任何内容。单个程序和名称可按其名称发送。</translation>
    </message>
    <message>
        <source>Sends back what differs from a backup of the same robot: first a fresh backup beside it, then file by file, each read back. Tools, frames and areas only by name; parameters, calibration and ladder never; never while a job runs.</source>
        <translation>发回与同一台机器人的备份不同的内容：先在旁边做一次新的备份，然后逐个文件发送，每个都回读。工具、坐标和干涉区仅在指定名称时发送；参数、校准和梯形图绝不发送；程序运行时绝不执行。</translation>
    </message>
    <message>
        <source>%1 bytes that are not a text.</source>
        <translation>%1 字节，不是文本。</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>The encoding of the pendant.</source>
        <translation>示教编程器的编码。</translation>
    </message>
    <message>
        <source>Tells what controller files say: names, tools, frames, variables, parameters, ladder, logs. Addresses, users and passwords are masked.</source>
        <translation>说明控制器文件的内容：名称、工具、坐标、变量、参数、梯形图、日志。地址、用户和密码会被遮盖。</translation>
    </message>
    <message>
        <source>Say a backup, a folder or files.</source>
        <translation>请指定备份、文件夹或文件。</translation>
    </message>
    <message>
        <source>There is no encoding “%1”.</source>
        <translation>没有编码“%1”。</translation>
    </message>
    <message>
        <source>--every takes a time such as 200ms or 1s.</source>
        <translation>--every 的值为时间，例如 200ms 或 1s。</translation>
    </message>
    <message>
        <source>Another signal of the group changed meanwhile; nothing was sent.</source>
        <translation>其间该组的另一个信号已改变；未发送任何内容。</translation>
    </message>
    <message>
        <source>not used in these files</source>
        <translation>在这些文件中未使用</translation>
    </message>
    <message>
        <source>a job that is known when the line runs</source>
        <translation>执行该行时才确定的程序</translation>
    </message>
    <message>
        <source>no file has it</source>
        <translation>没有文件包含它</translation>
    </message>
    <message>
        <source>Tells where variables, signals, registers, tools, frames, macros, alarms and jobs are used: in jobs, in the ladder, in files of names.</source>
        <translation>说明变量、信号、寄存器、工具、坐标系、宏、报警和程序的使用位置：程序、梯形图和名称文件中。</translation>
    </message>
    <message>
        <source>Say what to look for, such as B012, IN#(5) or a job.</source>
        <translation>请指定要查找的内容，例如 B012、IN#(5) 或程序名。</translation>
    </message>
    <message>
        <source>Tells which job calls, jumps to or starts which, line by line.</source>
        <translation>逐行说明哪个程序调用、跳转到或启动哪个程序。</translation>
    </message>
    <message>
        <source>Tells what is worth a look: jobs that nothing names, jobs that are missing, outputs with several writers, variables that are never written, tools that were not entered.</source>
        <translation>说明值得查看之处：无人引用的程序、缺失的程序、多处写入的输出、从未写入的变量、未输入的工具。</translation>
    </message>
    <message>
        <source>tell where variables, signals and jobs are used</source>
        <translation>说明变量、信号和程序的使用位置</translation>
    </message>
    <message>
        <source>tell which job calls which</source>
        <translation>说明程序之间的调用关系</translation>
    </message>
    <message>
        <source>tell what in the files is worth a look</source>
        <translation>说明文件中值得查看之处</translation>
    </message>
</context>
<context>
    <name>pendeskctl::AlarmReader</name>
    <message>
        <source>There are no alarms.</source>
        <translation>没有报警。</translation>
    </message>
</context>
<context>
    <name>pendeskctl::Gap</name>
    <message>
        <source>Answers again after %1 s.</source>
        <translation>%1 s 后重新应答。</translation>
    </message>
</context>
<context>
    <name>protocol</name>
    <message>
        <source>refused with status %1, which is not in the code list</source>
        <translation>被拒绝，状态 %1，不在代码表中</translation>
    </message>
    <message>
        <source>%1 refused, with a code that is not in the code list</source>
        <translation>%1 被拒绝，其代码不在代码表中</translation>
    </message>
    <message>
        <source>the controller did not answer; nothing was changed</source>
        <translation>控制器没有应答；未更改任何内容</translation>
    </message>
    <message>
        <source>no answer: it may or may not have happened — look at the robot</source>
        <translation>无应答：可能已执行，也可能未执行 — 请查看机器人</translation>
    </message>
    <message>
        <source>the answer does not fit the question</source>
        <translation>应答与请求不符</translation>
    </message>
    <message>
        <source>nothing was sent</source>
        <translation>未发送任何内容</translation>
    </message>
    <message>
        <source>this computer&apos;s network refused</source>
        <translation>被本计算机的网络拒绝</translation>
    </message>
    <message>
        <source>this cannot be sent to a controller</source>
        <translation>无法发送到控制器</translation>
    </message>
    <message>
        <source>a file on this computer could not be read or written</source>
        <translation>本计算机上的某个文件无法读取或写入</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>the command is faulty</source>
        <translation>命令有误</translation>
    </message>
    <message>
        <source>the command has the wrong number of operands</source>
        <translation>命令的操作数个数不正确</translation>
    </message>
    <message>
        <source>an operand is out of its range</source>
        <translation>操作数超出范围</translation>
    </message>
    <message>
        <source>an operand has the wrong length</source>
        <translation>操作数的长度不正确</translation>
    </message>
    <message>
        <source>the device holds too many files</source>
        <translation>存储设备中的文件过多</translation>
    </message>
    <message>
        <source>delete files that are not needed</source>
        <translation>请删除不需要的文件</translation>
    </message>
    <message>
        <source>the robot is running</source>
        <translation>机器人正在运行</translation>
    </message>
    <message>
        <source>wait until it has stopped, or hold it</source>
        <translation>请等待其停止，或执行 HOLD</translation>
    </message>
    <message>
        <source>held by the pendant</source>
        <translation>由示教编程器保持 HOLD</translation>
    </message>
    <message>
        <source>release HOLD on the pendant</source>
        <translation>请在示教编程器上解除 HOLD</translation>
    </message>
    <message>
        <source>held by the playback panel</source>
        <translation>由再现操作面板保持 HOLD</translation>
    </message>
    <message>
        <source>release HOLD on the panel or pendant</source>
        <translation>请在操作面板或示教编程器上解除 HOLD</translation>
    </message>
    <message>
        <source>held by an external signal</source>
        <translation>由外部信号保持 HOLD</translation>
    </message>
    <message>
        <source>release the external hold signal</source>
        <translation>请解除外部 HOLD 信号</translation>
    </message>
    <message>
        <source>held by a command</source>
        <translation>由命令保持 HOLD</translation>
    </message>
    <message>
        <source>switch HOLD off</source>
        <translation>请关闭 HOLD</translation>
    </message>
    <message>
        <source>an alarm or error is present</source>
        <translation>有报警或错误</translation>
    </message>
    <message>
        <source>remove its cause, then reset the alarm</source>
        <translation>请消除原因，然后进行报警复位</translation>
    </message>
    <message>
        <source>servo power is off</source>
        <translation>伺服电源已断开</translation>
    </message>
    <message>
        <source>switch servo on</source>
        <translation>请接通伺服</translation>
    </message>
    <message>
        <source>the controller is in the wrong mode</source>
        <translation>控制器的模式不正确</translation>
    </message>
    <message>
        <source>turn the pendant key to the mode needed, usually PLAY in REMOTE</source>
        <translation>请将示教编程器的钥匙开关转到所需模式，通常为 REMOTE 下的 PLAY</translation>
    </message>
    <message>
        <source>the files are in use by another function</source>
        <translation>文件正被其他功能使用</translation>
    </message>
    <message>
        <source>try again in a moment</source>
        <translation>请稍后重试</translation>
    </message>
    <message>
        <source>command remote is not enabled</source>
        <translation>命令远程未启用</translation>
    </message>
    <message>
        <source>turn the pendant key to REMOTE and enable command remote</source>
        <translation>请将示教编程器的钥匙开关转到 REMOTE，并启用命令远程</translation>
    </message>
    <message>
        <source>this data may not be accessed</source>
        <translation>不允许访问此数据</translation>
    </message>
    <message>
        <source>check the security mode and the data protection on the pendant</source>
        <translation>请在示教编程器上检查安全模式和数据保护</translation>
    </message>
    <message>
        <source>this data may not be loaded</source>
        <translation>不允许加载此数据</translation>
    </message>
    <message>
        <source>the data is being edited</source>
        <translation>数据正在编辑中</translation>
    </message>
    <message>
        <source>leave the editor on the pendant</source>
        <translation>请退出示教编程器上的编辑</translation>
    </message>
    <message>
        <source>a coordinate conversion is in progress</source>
        <translation>正在进行坐标变换</translation>
    </message>
    <message>
        <source>try again when it has ended</source>
        <translation>请在其结束后重试</translation>
    </message>
    <message>
        <source>servo power must be on first</source>
        <translation>必须先接通伺服电源</translation>
    </message>
    <message>
        <source>the home position must be set or checked</source>
        <translation>必须设定或确认原点位置</translation>
    </message>
    <message>
        <source>check the home position on the pendant</source>
        <translation>请在示教编程器上确认原点位置</translation>
    </message>
    <message>
        <source>the position must be checked</source>
        <translation>必须确认位置</translation>
    </message>
    <message>
        <source>confirm the position on the pendant</source>
        <translation>请在示教编程器上确认位置</translation>
    </message>
    <message>
        <source>the present position is not available</source>
        <translation>无法取得当前位置</translation>
    </message>
    <message>
        <source>the panel lock prohibits a change of mode or cycle</source>
        <translation>面板锁定禁止更改模式或循环</translation>
    </message>
    <message>
        <source>release the panel lock</source>
        <translation>请解除面板锁定</translation>
    </message>
    <message>
        <source>the panel lock prohibits a start</source>
        <translation>面板锁定禁止启动</translation>
    </message>
    <message>
        <source>the user frame is not taught</source>
        <translation>用户坐标未示教</translation>
    </message>
    <message>
        <source>teach the user frame</source>
        <translation>请示教用户坐标</translation>
    </message>
    <message>
        <source>the user frame data is damaged</source>
        <translation>用户坐标数据已损坏</translation>
    </message>
    <message>
        <source>teach the user frame again</source>
        <translation>请重新示教用户坐标</translation>
    </message>
    <message>
        <source>the control group is wrong</source>
        <translation>控制轴组不正确</translation>
    </message>
    <message>
        <source>choose a control group that this controller has</source>
        <translation>请选择此控制器具有的控制轴组</translation>
    </message>
    <message>
        <source>the base axis data is wrong</source>
        <translation>基座轴数据不正确</translation>
    </message>
    <message>
        <source>a relative job may not be converted</source>
        <translation>不允许变换相对程序</translation>
    </message>
    <message>
        <source>permit the conversion on the pendant</source>
        <translation>请在示教编程器上允许变换</translation>
    </message>
    <message>
        <source>a parameter prohibits calling the master job</source>
        <translation>参数禁止调用主程序</translation>
    </message>
    <message>
        <source>permit the master call on the pendant</source>
        <translation>请在示教编程器上允许调用主程序</translation>
    </message>
    <message>
        <source>the master job may not be called while operating</source>
        <translation>运行中不允许调用主程序</translation>
    </message>
    <message>
        <source>wait until the operation has ended</source>
        <translation>请等待运行结束</translation>
    </message>
    <message>
        <source>the teach lock prohibits calling the master job</source>
        <translation>示教锁定禁止调用主程序</translation>
    </message>
    <message>
        <source>release the teach lock</source>
        <translation>请解除示教锁定</translation>
    </message>
    <message>
        <source>robot calibration data is missing</source>
        <translation>缺少机器人校准数据</translation>
    </message>
    <message>
        <source>calibrate the robots</source>
        <translation>请校准机器人</translation>
    </message>
    <message>
        <source>servo power cannot be switched on</source>
        <translation>无法接通伺服电源</translation>
    </message>
    <message>
        <source>check the safety chain: emergency stop, safeguards, alarms</source>
        <translation>请检查安全回路：急停、安全防护、报警</translation>
    </message>
    <message>
        <source>the coordinate system cannot be set</source>
        <translation>无法设定坐标系</translation>
    </message>
    <message>
        <source>no memory is left for jobs</source>
        <translation>没有可用于程序的内存</translation>
    </message>
    <message>
        <source>delete jobs that are not needed</source>
        <translation>请删除不需要的程序</translation>
    </message>
    <message>
        <source>no memory is left for position data</source>
        <translation>没有可用于位置数据的内存</translation>
    </message>
    <message>
        <source>editing of this job is prohibited</source>
        <translation>此程序禁止编辑</translation>
    </message>
    <message>
        <source>remove the edit lock of the job</source>
        <translation>请解除该程序的编辑锁定</translation>
    </message>
    <message>
        <source>a job of that name exists</source>
        <translation>已有同名程序</translation>
    </message>
    <message>
        <source>delete or rename it, or permit overwriting</source>
        <translation>请将其删除或重命名，或者允许覆盖</translation>
    </message>
    <message>
        <source>the job was not found</source>
        <translation>未找到程序</translation>
    </message>
    <message>
        <source>check the job name</source>
        <translation>请检查程序名</translation>
    </message>
    <message>
        <source>no job is set for execution</source>
        <translation>未设定执行程序</translation>
    </message>
    <message>
        <source>select a job first</source>
        <translation>请先选择程序</translation>
    </message>
    <message>
        <source>position data is damaged</source>
        <translation>位置数据已损坏</translation>
    </message>
    <message>
        <source>load the job again from a backup</source>
        <translation>请从备份重新加载程序</translation>
    </message>
    <message>
        <source>position data is missing</source>
        <translation>缺少位置数据</translation>
    </message>
    <message>
        <source>teach the missing position</source>
        <translation>请示教缺少的位置</translation>
    </message>
    <message>
        <source>the position variable has the wrong type</source>
        <translation>位置变量的类型不正确</translation>
    </message>
    <message>
        <source>write the type that the variable is declared with</source>
        <translation>请按变量声明的类型写入</translation>
    </message>
    <message>
        <source>END was reached in a job that is not the master</source>
        <translation>在非主程序的程序中到达 END</translation>
    </message>
    <message>
        <source>instruction data is damaged</source>
        <translation>命令数据已损坏</translation>
    </message>
    <message>
        <source>the job name has a character that is not allowed</source>
        <translation>程序名含有不允许的字符</translation>
    </message>
    <message>
        <source>rename the job</source>
        <translation>请重命名程序</translation>
    </message>
    <message>
        <source>a label has a character that is not allowed</source>
        <translation>标号含有不允许的字符</translation>
    </message>
    <message>
        <source>rename the label</source>
        <translation>请重命名标号</translation>
    </message>
    <message>
        <source>this system does not have the instruction</source>
        <translation>此系统没有该命令</translation>
    </message>
    <message>
        <source>the job to convert has no steps</source>
        <translation>要变换的程序没有程序点</translation>
    </message>
    <message>
        <source>the job is converted already</source>
        <translation>程序已经变换</translation>
    </message>
    <message>
        <source>the user frame must be taught</source>
        <translation>必须示教用户坐标</translation>
    </message>
    <message>
        <source>relative jobs or independent control are not permitted</source>
        <translation>不允许相对程序或独立控制</translation>
    </message>
    <message>
        <source>an instruction has a syntax error</source>
        <translation>命令有语法错误</translation>
    </message>
    <message>
        <source>correct the instruction</source>
        <translation>请更正命令</translation>
    </message>
    <message>
        <source>the position data has an error</source>
        <translation>位置数据有错误</translation>
    </message>
    <message>
        <source>correct the position section</source>
        <translation>请更正位置数据段</translation>
    </message>
    <message>
        <source>NOP or END is missing</source>
        <translation>缺少 NOP 或 END</translation>
    </message>
    <message>
        <source>begin the instructions with NOP and end them with END</source>
        <translation>命令段须以 NOP 开始、以 END 结束</translation>
    </message>
    <message>
        <source>the format is wrong</source>
        <translation>格式不正确</translation>
    </message>
    <message>
        <source>the number of data is wrong</source>
        <translation>数据个数不正确</translation>
    </message>
    <message>
        <source>correct the counts in the NPOS line</source>
        <translation>请更正 NPOS 行中的个数</translation>
    </message>
    <message>
        <source>a value is out of range</source>
        <translation>某个值超出范围</translation>
    </message>
    <message>
        <source>correct the value</source>
        <translation>请更正该值</translation>
    </message>
    <message>
        <source>there is a syntax error outside the instructions</source>
        <translation>命令以外的部分有语法错误</translation>
    </message>
    <message>
        <source>correct the header of the file</source>
        <translation>请更正文件头</translation>
    </message>
    <message>
        <source>a pseudo instruction is wrong</source>
        <translation>伪指令不正确</translation>
    </message>
    <message>
        <source>correct the line that starts with slashes</source>
        <translation>请更正以斜杠开头的行</translation>
    </message>
    <message>
        <source>a record of a condition file has an error</source>
        <translation>条件文件的记录有错误</translation>
    </message>
    <message>
        <source>a record of a job has an error</source>
        <translation>程序的记录有错误</translation>
    </message>
    <message>
        <source>the data comes from a different system</source>
        <translation>数据来自不同的系统</translation>
    </message>
    <message>
        <source>the welding type does not match</source>
        <translation>焊接类型不匹配</translation>
    </message>
    <message>
        <source>the robot or station is operating</source>
        <translation>机器人或工装轴正在运行</translation>
    </message>
    <message>
        <source>back up when nothing moves</source>
        <translation>请在没有任何移动时备份</translation>
    </message>
    <message>
        <source>the device has too little memory</source>
        <translation>存储设备的内存不足</translation>
    </message>
    <message>
        <source>free memory on the device or use a larger one</source>
        <translation>请释放存储设备的空间或使用容量更大的设备</translation>
    </message>
    <message>
        <source>the device cannot be accessed</source>
        <translation>无法访问存储设备</translation>
    </message>
    <message>
        <source>check that the device is inserted</source>
        <translation>请检查存储设备是否已插入</translation>
    </message>
    <message>
        <source>a backup was not expected now</source>
        <translation>此时不应有备份</translation>
    </message>
    <message>
        <source>the image is larger than the RAM area</source>
        <translation>映像大于 RAM 区域</translation>
    </message>
    <message>
        <source>enlarge the RAM area for backups</source>
        <translation>请扩大用于备份的 RAM 区域</translation>
    </message>
    <message>
        <source>no memory was reserved at power-on</source>
        <translation>接通电源时未预留内存</translation>
    </message>
    <message>
        <source>switch the controller off and on</source>
        <translation>请将控制器的电源断开后再接通</translation>
    </message>
    <message>
        <source>the backup file information cannot be accessed</source>
        <translation>无法访问备份文件信息</translation>
    </message>
    <message>
        <source>the old backup could not be removed</source>
        <translation>无法移除旧的备份</translation>
    </message>
    <message>
        <source>the backup could not be renamed</source>
        <translation>无法重命名备份</translation>
    </message>
    <message>
        <source>the drive name is too long</source>
        <translation>驱动器名称过长</translation>
    </message>
    <message>
        <source>the device is the wrong one</source>
        <translation>存储设备不正确</translation>
    </message>
    <message>
        <source>set the automatic backup to the RAM disk</source>
        <translation>请将自动备份设为 RAM 盘</translation>
    </message>
    <message>
        <source>a system error occurred</source>
        <translation>发生了系统错误</translation>
    </message>
    <message>
        <source>automatic backup is not available</source>
        <translation>自动备份不可用</translation>
    </message>
    <message>
        <source>set up automatic backup on the pendant</source>
        <translation>请在示教编程器上设置自动备份</translation>
    </message>
    <message>
        <source>an automatic backup is running</source>
        <translation>正在进行自动备份</translation>
    </message>
    <message>
        <source>the controller does not know this command</source>
        <translation>控制器没有此命令</translation>
    </message>
    <message>
        <source>the number does not exist on this controller</source>
        <translation>此控制器上没有该编号</translation>
    </message>
    <message>
        <source>check the number and the variable numbering</source>
        <translation>请检查编号和变量编号方式</translation>
    </message>
    <message>
        <source>the element does not exist on this controller</source>
        <translation>此控制器上没有该元素</translation>
    </message>
    <message>
        <source>the reply would be too large for the hardware</source>
        <translation>应答对硬件而言过大</translation>
    </message>
    <message>
        <source>ask for less at once</source>
        <translation>请减少一次请求的数量</translation>
    </message>
    <message>
        <source>the reply would be too large</source>
        <translation>应答过大</translation>
    </message>
    <message>
        <source>the position variable is not defined</source>
        <translation>位置变量未定义</translation>
    </message>
    <message>
        <source>teach or write it first</source>
        <translation>请先示教或写入该变量</translation>
    </message>
    <message>
        <source>this data may not be used</source>
        <translation>不允许使用此数据</translation>
    </message>
    <message>
        <source>the size of the request data is wrong</source>
        <translation>请求数据的大小不正确</translation>
    </message>
    <message>
        <source>the data is not set</source>
        <translation>数据未设定</translation>
    </message>
    <message>
        <source>set it first</source>
        <translation>请先设定</translation>
    </message>
    <message>
        <source>the application is not registered</source>
        <translation>应用未登记</translation>
    </message>
    <message>
        <source>the type is not registered</source>
        <translation>类型未登记</translation>
    </message>
    <message>
        <source>the control group setting is wrong</source>
        <translation>控制轴组的设定不正确</translation>
    </message>
    <message>
        <source>name either robots or stations that this controller has</source>
        <translation>请指定此控制器具有的机器人轴或工装轴，二者只能选其一</translation>
    </message>
    <message>
        <source>the speed setting is wrong</source>
        <translation>速度设定不正确</translation>
    </message>
    <message>
        <source>use percent for joint and mm/s or °/s for straight moves</source>
        <translation>关节移动请使用百分比，直线移动请使用 mm/s 或 °/s</translation>
    </message>
    <message>
        <source>no speed is given</source>
        <translation>未指定速度</translation>
    </message>
    <message>
        <source>give a speed above 0</source>
        <translation>请指定大于 0 的速度</translation>
    </message>
    <message>
        <source>the coordinate system setting is wrong</source>
        <translation>坐标系的设定不正确</translation>
    </message>
    <message>
        <source>the type or form setting is wrong</source>
        <translation>类型或形态的设定不正确</translation>
    </message>
    <message>
        <source>the tool number is wrong</source>
        <translation>工具号不正确</translation>
    </message>
    <message>
        <source>use 0 to 63</source>
        <translation>请使用 0 至 63</translation>
    </message>
    <message>
        <source>the user frame number is wrong</source>
        <translation>用户坐标号不正确</translation>
    </message>
    <message>
        <source>use 1 to 63 with a user frame, else 0</source>
        <translation>使用用户坐标时请用 1 至 63，否则用 0</translation>
    </message>
    <message>
        <source>internal error of the controller: data area</source>
        <translation>控制器内部错误：数据区</translation>
    </message>
    <message>
        <source>internal error of the controller: reply area exceeded</source>
        <translation>控制器内部错误：超出应答区</translation>
    </message>
    <message>
        <source>internal error of the controller: element size mismatch</source>
        <translation>控制器内部错误：元素大小不匹配</translation>
    </message>
    <message>
        <source>internal error of the controller: customised function</source>
        <translation>控制器内部错误：定制功能</translation>
    </message>
    <message>
        <source>another error</source>
        <translation>其他错误</translation>
    </message>
    <message>
        <source>busy with another command</source>
        <translation>正忙于其他命令</translation>
    </message>
    <message>
        <source>another access is in progress</source>
        <translation>正在进行其他访问</translation>
    </message>
    <message>
        <source>the backup parameter setting is wrong</source>
        <translation>备份参数的设定不正确</translation>
    </message>
    <message>
        <source>the backup file was not created</source>
        <translation>未创建备份文件</translation>
    </message>
    <message>
        <source>check that the controller is in remote mode</source>
        <translation>请检查控制器是否处于远程模式</translation>
    </message>
    <message>
        <source>internal system error of the controller</source>
        <translation>控制器内部系统错误</translation>
    </message>
    <message>
        <source>the transfer was dropped: nothing came in time</source>
        <translation>传输已中止：未及时收到数据</translation>
    </message>
    <message>
        <source>start the transfer again</source>
        <translation>请重新开始传输</translation>
    </message>
    <message>
        <source>the file cannot be overwritten</source>
        <translation>无法覆盖该文件</translation>
    </message>
    <message>
        <source>permit overwriting, or delete the file first</source>
        <translation>请允许覆盖，或先删除该文件</translation>
    </message>
    <message>
        <source>the file is missing or empty</source>
        <translation>文件不存在或为空</translation>
    </message>
    <message>
        <source>check the file name</source>
        <translation>请检查文件名</translation>
    </message>
    <message>
        <source>the path is wrong</source>
        <translation>路径不正确</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>请检查路径</translation>
    </message>
    <message>
        <source>the file is not in the list</source>
        <translation>文件不在列表中</translation>
    </message>
    <message>
        <source>the file may not be deleted</source>
        <translation>不允许删除该文件</translation>
    </message>
    <message>
        <source>the directory may not be deleted</source>
        <translation>不允许删除该目录</translation>
    </message>
    <message>
        <source>files cannot be accessed while remote is off</source>
        <translation>远程关闭时无法访问文件</translation>
    </message>
    <message>
        <source>the file was not found</source>
        <translation>未找到文件</translation>
    </message>
    <message>
        <source>the path is too long</source>
        <translation>路径过长</translation>
    </message>
    <message>
        <source>use a shorter name</source>
        <translation>请使用较短的名称</translation>
    </message>
    <message>
        <source>packet without data</source>
        <translation>数据包没有数据</translation>
    </message>
    <message>
        <source>packet too large</source>
        <translation>数据包过大</translation>
    </message>
    <message>
        <source>packet of size 0</source>
        <translation>数据包大小为 0</translation>
    </message>
    <message>
        <source>packet with a wrong block number</source>
        <translation>数据包的块编号不正确</translation>
    </message>
    <message>
        <source>packet with a wrong ACK byte</source>
        <translation>数据包的 ACK 字节不正确</translation>
    </message>
    <message>
        <source>packet of a wrong division</source>
        <translation>数据包的处理区分不正确</translation>
    </message>
    <message>
        <source>check that robot and file port are not exchanged</source>
        <translation>请检查机器人端口和文件端口是否互换</translation>
    </message>
    <message>
        <source>packet with a wrong access level</source>
        <translation>数据包的访问级别不正确</translation>
    </message>
    <message>
        <source>packet with a wrong header size</source>
        <translation>数据包的头部大小不正确</translation>
    </message>
    <message>
        <source>packet with a wrong identifier</source>
        <translation>数据包的标识符不正确</translation>
    </message>
    <message>
        <source>announced and received packet sizes differ</source>
        <translation>声明的与收到的数据包大小不一致</translation>
    </message>
    <message>
        <source>too many requests</source>
        <translation>请求过多</translation>
    </message>
    <message>
        <source>ask less often, or try again in a moment</source>
        <translation>请降低请求频率，或稍后重试</translation>
    </message>
    <message>
        <source>the mode was changed and the communication dropped</source>
        <translation>模式已改变，通信已断开</translation>
    </message>
    <message>
        <source>start again in the new mode</source>
        <translation>请在新的模式下重新开始</translation>
    </message>
</context>
<context>
    <name>robot::Controller</name>
    <message>
        <source>The name %1 is not known to this computer.</source>
        <translation>本计算机找不到名称 %1。</translation>
    </message>
</context>
<context>
    <name>robot::Diagnosis</name>
    <message>
        <source>Host name</source>
        <translation>主机名</translation>
    </message>
    <message>
        <source>Way to the host</source>
        <translation>到主机的路径</translation>
    </message>
    <message>
        <source>Robot port</source>
        <translation>机器人端口</translation>
    </message>
    <message>
        <source>System information</source>
        <translation>系统信息</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>文件端口</translation>
    </message>
    <message>
        <source>Not looked at, because the step before it failed.</source>
        <translation>未检查，因为前一步骤失败。</translation>
    </message>
    <message>
        <source>The name “%1” has no IPv4 address on this computer.</source>
        <translation>名称“%1”在本计算机上没有 IPv4 地址。</translation>
    </message>
    <message>
        <source>Check the spelling, or enter the controller&apos;s IPv4 address as the pendant shows it.</source>
        <translation>请检查拼写，或输入示教编程器上显示的控制器 IPv4 地址。</translation>
    </message>
    <message>
        <source>%1 is %2.</source>
        <translation>%1 为 %2。</translation>
    </message>
    <message>
        <source>This computer cannot send to %1: %2.</source>
        <translation>本计算机无法向 %1 发送：%2。</translation>
    </message>
    <message>
        <source>Check the cable and this computer&apos;s IPv4 address: it must be in the controller&apos;s network.</source>
        <translation>请检查电缆和本计算机的 IPv4 地址：必须与控制器在同一网络中。</translation>
    </message>
    <message>
        <source>This computer can send to %1.</source>
        <translation>本计算机可以向 %1 发送。</translation>
    </message>
    <message>
        <source>Port %1 answers with a status.</source>
        <translation>端口 %1 以状态应答。</translation>
    </message>
    <message>
        <source>Port %1 answers but refuses to tell the status: %2</source>
        <translation>端口 %1 有应答，但拒绝提供状态：%2</translation>
    </message>
    <message>
        <source>Check on the pendant that the network function server is enabled for this computer.</source>
        <translation>请在示教编程器上检查是否已对本计算机启用网络功能服务器。</translation>
    </message>
    <message>
        <source>Answers come from another address than %1; they are ignored.</source>
        <translation>应答来自 %1 以外的地址；已将其忽略。</translation>
    </message>
    <message>
        <source>Look for a second network card or an address translation between this computer and the controller.</source>
        <translation>请检查本计算机与控制器之间是否有第二块网卡或地址转换。</translation>
    </message>
    <message>
        <source>Something answers at port %1, but not with HSES.</source>
        <translation>端口 %1 有应答，但不是 HSES。</translation>
    </message>
    <message>
        <source>Check the address and the port: HSES is UDP %1 on a controller.</source>
        <translation>请检查地址和端口：控制器上的 HSES 为 UDP %1。</translation>
    </message>
    <message>
        <source>The host rejects port %1: %2.</source>
        <translation>主机拒绝端口 %1：%2。</translation>
    </message>
    <message>
        <source>The host is there, but no HSES server: enable the Ethernet server function on the controller.</source>
        <translation>主机存在，但没有 HSES 服务器：请在控制器上启用以太网服务器功能。</translation>
    </message>
    <message>
        <source>Port %1 stays silent.</source>
        <translation>端口 %1 没有应答。</translation>
    </message>
    <message>
        <source>Check that the controller is on, that its Ethernet server function is enabled and that no firewall drops UDP %1.</source>
        <translation>请检查控制器是否已接通电源、其以太网服务器功能是否已启用，以及是否有防火墙丢弃 UDP %1。</translation>
    </message>
    <message>
        <source>The controller runs %1.</source>
        <translation>控制器运行的是 %1。</translation>
    </message>
    <message>
        <source>The controller does not tell its system information: %1</source>
        <translation>控制器不提供系统信息：%1</translation>
    </message>
    <message>
        <source>Pendesk monitors only a controller that says what it is. Ask its maker for the HSES option.</source>
        <translation>Pendesk 只监视提供自身信息的控制器。请向控制器制造商咨询 HSES 选项。</translation>
    </message>
    <message>
        <source>Port %1 stays silent: files are unavailable, monitoring works.</source>
        <translation>端口 %1 没有应答：文件不可用，监视可用。</translation>
    </message>
    <message>
        <source>Check that no firewall drops UDP %1.</source>
        <translation>请检查是否有防火墙丢弃 UDP %1。</translation>
    </message>
    <message>
        <source>Port %1 answers.</source>
        <translation>端口 %1 有应答。</translation>
    </message>
</context>
<context>
    <name>session::FileSession</name>
    <message>
        <source>An empty file cannot be sent over HSES.</source>
        <translation>空文件无法通过 HSES 发送。</translation>
    </message>
</context>
<context>
    <name>settings</name>
    <message>
        <source>%1 must be a whole number from %2 to %3.</source>
        <translation>%1 必须是 %2 至 %3 的整数。</translation>
    </message>
    <message>
        <source>The model “%1” is not known.</source>
        <translation>未知的机型“%1”。</translation>
    </message>
    <message>
        <source>The text encoding “%1” is not known.</source>
        <translation>未知的文本编码“%1”。</translation>
    </message>
    <message>
        <source>The variable numbering must be 0 or 1.</source>
        <translation>变量编号必须是 0 或 1。</translation>
    </message>
    <message>
        <source>Pulses per degree must be lists of numbers, one list for each control group.</source>
        <translation>每度脉冲数必须是数的列表，每个控制轴组一个列表。</translation>
    </message>
    <message>
        <source>The profile needs a name.</source>
        <translation>配置需要名称。</translation>
    </message>
    <message>
        <source>The profile needs the controller&apos;s host name or IPv4 address.</source>
        <translation>配置需要控制器的主机名或 IPv4 地址。</translation>
    </message>
</context>
<context>
    <name>settings::CommandLine</name>
    <message>
        <source>--%1 must be a whole number from 1 to 65535.</source>
        <translation>--%1 必须是 1 至 65535 的整数。</translation>
    </message>
    <message>
        <source>--timeout takes a time such as 300ms or 1s.</source>
        <translation>--timeout 的值为时间，例如 300ms 或 1s。</translation>
    </message>
    <message>
        <source>There is no controller stored under the name “%1”.</source>
        <translation>没有以名称“%1”保存的控制器。</translation>
    </message>
    <message>
        <source>Connect to the controller with this name or IPv4 address.</source>
        <translation>连接到具有此名称或 IPv4 地址的控制器。</translation>
    </message>
    <message>
        <source>Its port for robot control, 10040 unless told otherwise.</source>
        <translation>控制器的机器人控制端口，未指定时为 10040。</translation>
    </message>
    <message>
        <source>Its port for file control, 10041 unless told otherwise.</source>
        <translation>控制器的文件控制端口，未指定时为 10041。</translation>
    </message>
    <message>
        <source>Connect to the controller that is stored under this name.</source>
        <translation>连接到以此名称保存的控制器。</translation>
    </message>
    <message>
        <source>How long to wait for one try of a read: 300ms, 1s.</source>
        <translation>每次尝试读取的等待时间：300ms、1s。</translation>
    </message>
    <message>
        <source>--%1 needs --host or --profile.</source>
        <translation>--%1 需要 --host 或 --profile。</translation>
    </message>
    <message>
        <source>--model must be dx100, dx200, fs100, yrc1000 or yrc1000micro.</source>
        <translation>--model 必须是 dx100、dx200、fs100、yrc1000 或 yrc1000micro。</translation>
    </message>
    <message>
        <source>Its model: dx100, dx200, fs100, yrc1000 or yrc1000micro.</source>
        <translation>控制器的机型：dx100、dx200、fs100、yrc1000 或 yrc1000micro。</translation>
    </message>
    <message>
        <source>What to log, as &quot;pendesk.session=true;pendesk.journal.debug=false&quot;.</source>
        <translation>要记录的日志内容，例如 &quot;pendesk.session=true;pendesk.journal.debug=false&quot;。</translation>
    </message>
</context>
<context>
    <name>settings::Profile</name>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>文件端口</translation>
    </message>
    <message>
        <source>Read time-out</source>
        <translation>读取超时</translation>
    </message>
    <message>
        <source>File time-out</source>
        <translation>文件超时</translation>
    </message>
    <message>
        <source>Servo time-out</source>
        <translation>伺服超时</translation>
    </message>
    <message>
        <source>Repeats of a read</source>
        <translation>读取重试次数</translation>
    </message>
    <message>
        <source>Requests outstanding at once</source>
        <translation>同时未完成的请求数</translation>
    </message>
    <message>
        <source>Requests a second</source>
        <translation>每秒请求数</translation>
    </message>
</context>
<context>
    <name>settings::SettingsFile</name>
    <message>
        <source>The last good ones, of %1, are used.</source>
        <translation>使用 %1 的最后一份完好的设置。</translation>
    </message>
    <message>
        <source>There is no good copy of them.</source>
        <translation>没有完好的设置副本。</translation>
    </message>
    <message>
        <source>The settings in %1 are gone.</source>
        <translation>%1 中的设置已丢失。</translation>
    </message>
    <message>
        <source>The settings cannot be read: %1.</source>
        <translation>无法读取设置：%1。</translation>
    </message>
    <message>
        <source>The settings are damaged; they are kept as %1.</source>
        <translation>设置已损坏；已将其保留为 %1。</translation>
    </message>
    <message>
        <source>another program holds %1</source>
        <translation>%1 被其他软件占用</translation>
    </message>
    <message>
        <source>Settings could not be saved in time and are lost: %1</source>
        <translation>设置未能及时保存，已丢失：%1</translation>
    </message>
    <message>
        <source>Settings cannot be saved: %1. Work goes on; it is tried again.</source>
        <translation>无法保存设置：%1。可继续工作；将重试保存。</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(ies) of the earlier settings cannot be read; they stay in %1.</source>
        <translation>
            <numerusform>先前设置中有 %n 个条目无法读取；它们保留在 %1 中。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>station::Fleet</name>
    <message>
        <source>%1: %2</source>
        <comment>controller: sentence</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>station::Station</name>
    <message numerus="yes">
        <source>%n staged value(s) were not applied.</source>
        <translation>
            <numerusform>%n 个暂存的值尚未应用。</numerusform>
        </translation>
    </message>
    <message>
        <source>Files are still being transferred.</source>
        <translation>仍在传输文件。</translation>
    </message>
    <message>
        <source>Files are still being read or sent for a backup, a comparison or a restore.</source>
        <translation>仍在为备份、比较或恢复读取或发送文件。</translation>
    </message>
</context>
<context>
    <name>trend</name>
    <message>
        <source>Alarm %1 [%2] %3</source>
        <translation>报警 %1 [%2] %3</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>程序 %1</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Step mode</source>
        <translation>单步模式</translation>
    </message>
    <message>
        <source>One cycle</source>
        <translation>单循环</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>连续</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>速度限制</translation>
    </message>
    <message>
        <source>TEACH</source>
        <translation>TEACH</translation>
    </message>
    <message>
        <source>PLAY</source>
        <translation>PLAY</translation>
    </message>
    <message>
        <source>REMOTE</source>
        <translation>REMOTE</translation>
    </message>
    <message>
        <source>Held by the pendant</source>
        <translation>由示教编程器保持 HOLD</translation>
    </message>
    <message>
        <source>Held externally</source>
        <translation>由外部保持 HOLD</translation>
    </message>
    <message>
        <source>Held by command</source>
        <translation>由命令保持 HOLD</translation>
    </message>
    <message>
        <source>Alarm active</source>
        <translation>有报警</translation>
    </message>
    <message>
        <source>Error active</source>
        <translation>有错误</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>接通伺服</translation>
    </message>
    <message>
        <source>Job line</source>
        <translation>程序行</translation>
    </message>
    <message>
        <source>Job step</source>
        <translation>程序点</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>速度倍率</translation>
    </message>
    <message>
        <source>%1, sub task %2</source>
        <translation>%1，子任务 %2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 following error</source>
        <translation>%1 %2 跟随误差</translation>
    </message>
    <message>
        <source>%1 %2 torque</source>
        <translation>%1 %2 转矩</translation>
    </message>
    <message>
        <source>%1 %2 encoder temperature</source>
        <translation>%1 %2 编码器温度</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>脉冲</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <source>Converter temperature, board %1</source>
        <translation>整流器温度，基板 %1</translation>
    </message>
    <message>
        <source>Running time %1</source>
        <translation>运行时间 %1</translation>
    </message>
    <message>
        <source>Alarm code %1</source>
        <translation>报警代码 %1</translation>
    </message>
</context>
<context>
    <name>trend::Recorder</name>
    <message>
        <source>An incident is lost: %1 could not be written in time.</source>
        <translation>一个事件已丢失：%1 未能及时写入。</translation>
    </message>
</context>
<context>
    <name>ui::AccessSwitch</name>
    <message>
        <source>Passcode and idle time…</source>
        <translation>密码和空闲时间…</translation>
    </message>
    <message>
        <source>Access level: %1</source>
        <translation>访问级别：%1</translation>
    </message>
    <message>
        <source>This program was started with --monitor-only: it watches and holds.</source>
        <translation>本软件以 --monitor-only 启动：仅可监视和发送 HOLD。</translation>
    </message>
    <message numerus="yes">
        <source>What may be done from here. It falls back to Monitor after %n minute(s) without key or mouse.</source>
        <translation>
            <numerusform>可从此处进行的操作。%n 分钟内无键盘或鼠标操作，将退回“监视”。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::Announcer</name>
    <message>
        <source>New alarm %1: %2</source>
        <translation>新报警 %1：%2</translation>
    </message>
</context>
<context>
    <name>ui::ArmBadge</name>
    <message>
        <source>This controller is armed: press to disarm.</source>
        <translation>此控制器已激活：按此取消激活。</translation>
    </message>
    <message>
        <source>ARMED · %1 s</source>
        <translation>已激活 · %1 s</translation>
    </message>
    <message numerus="yes">
        <source>Armed for %n more second(s). Press to disarm.</source>
        <translation>
            <numerusform>激活状态还剩 %n 秒。按此取消激活。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::BackupAge</name>
    <message>
        <source>No backup</source>
        <translation>无备份</translation>
    </message>
    <message numerus="yes">
        <source>Backup %n hour(s) old</source>
        <translation>
            <numerusform>备份于 %n 小时前</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Backup %n day(s) old</source>
        <translation>
            <numerusform>备份于 %n 天前</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Old backup: %n day(s)</source>
        <translation>
            <numerusform>备份已旧：%n 天</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ControllerView</name>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>HLOCK is on at %1: the pendant is locked out, but for its emergency stop.</source>
        <translation>%1 的 HLOCK 已开启：示教编程器除急停外均被锁定。</translation>
    </message>
    <message>
        <source>Release HLOCK</source>
        <translation>解除 HLOCK</translation>
    </message>
    <message numerus="yes">
        <source>The journal works again. %n record(s) were lost.</source>
        <translation>
            <numerusform>日志恢复正常。丢失了 %n 条记录。</numerusform>
        </translation>
    </message>
    <message>
        <source>The journal was damaged. It was kept as %1, and a new one was begun.</source>
        <translation>日志已损坏。已将其保留为 %1，并新建了日志。</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Level: %1</source>
        <translation>级别：%1</translation>
    </message>
    <message>
        <source>HLOCK is on</source>
        <translation>HLOCK 已开启</translation>
    </message>
    <message>
        <source>Pendesk</source>
        <translation>Pendesk</translation>
    </message>
    <message>
        <source>%1 — Pendesk</source>
        <translation>%1 — Pendesk</translation>
    </message>
    <message>
        <source>The demo could not be started: %1.</source>
        <translation>无法启动演示：%1。</translation>
    </message>
    <message>
        <source>About Pendesk</source>
        <translation>关于 Pendesk</translation>
    </message>
    <message>
        <source>Pendesk %1

A teach and monitor desk for Yaskawa robot controllers.
Free software under the GNU General Public License, version 3 or later.

HOLD is a software hold over the network, not a safety function.</source>
        <translation>Pendesk %1

安川机器人控制器的示教和监视软件。
自由软件，采用 GNU 通用公共许可证第 3 版或更新版本。

HOLD 是通过网络执行的软件 HOLD，不是安全功能。</translation>
    </message>
    <message>
        <source>There is no connection.</source>
        <translation>没有连接。</translation>
    </message>
    <message>
        <source>The connection is open.</source>
        <translation>连接已打开。</translation>
    </message>
    <message>
        <source>No controller is chosen.</source>
        <translation>未选择控制器。</translation>
    </message>
    <message>
        <source>No controller is chosen: connect first.</source>
        <translation>未选择控制器：请先连接。</translation>
    </message>
    <message>
        <source>%1 requests/s</source>
        <translation>%1 请求/s</translation>
    </message>
    <message>
        <source>Something is unfinished</source>
        <translation>有未完成的内容</translation>
    </message>
    <message>
        <source>Go on and lose it</source>
        <translation>继续并放弃</translation>
    </message>
    <message>
        <source>HLOCK is still on at %1: the pendant stays locked out if you go on.</source>
        <translation>%1 的 HLOCK 仍处于开启状态：如果继续，示教编程器仍被锁定。</translation>
    </message>
    <message>
        <source>Release HLOCK and go on</source>
        <translation>解除 HLOCK 并继续</translation>
    </message>
    <message>
        <source>Go on and leave it on</source>
        <translation>继续并保持开启</translation>
    </message>
</context>
<context>
    <name>ui::NavigationRail</name>
    <message>
        <source>CONTROLLERS</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>PAGES</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>CONNECTION</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>菜单</translation>
    </message>
</context>
<context>
    <name>ui::RobotStrip</name>
    <message>
        <source>SIMULATION</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>链路</translation>
    </message>
    <message>
        <source>No controller</source>
        <translation>无控制器</translation>
    </message>
    <message>
        <source>Link · %1 ago</source>
        <translation>链路 · %1 前</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>LOST</source>
        <translation>中断</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>伺服</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Job · %1</source>
        <translation>程序 · %1</translation>
    </message>
</context>
<context>
    <name>ui::StationList</name>
    <message numerus="yes">
        <source>%n more in Fleet</source>
        <translation>
            <numerusform>机群中另有 %n 台</numerusform>
        </translation>
    </message>
    <message>
        <source>No controller</source>
        <translation>无控制器</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>未连接</translation>
    </message>
</context>
<context>
    <name>values</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>number</source>
        <translation>数</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 位</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>conveyor files</source>
        <translation>传送带文件</translation>
    </message>
    <message>
        <source>robots and stations</source>
        <translation>机器人轴和工装轴</translation>
    </message>
    <message>
        <source>signed number</source>
        <translation>有符号数</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 位</translation>
    </message>
    <message>
        <source>robots</source>
        <translation>机器人轴</translation>
    </message>
    <message>
        <source>robots, stations and bases</source>
        <translation>机器人轴、工装轴和基座轴</translation>
    </message>
    <message>
        <source>control group, low and high axes</source>
        <translation>控制轴组，低位轴和高位轴</translation>
    </message>
    <message>
        <source>control group, minimum and maximum axes</source>
        <translation>控制轴组，最小轴和最大轴</translation>
    </message>
    <message>
        <source>control group, minimum and maximum X Y Z</source>
        <translation>控制轴组，最小和最大 X Y Z</translation>
    </message>
    <message>
        <source>axes of two control groups</source>
        <translation>两个控制轴组的轴</translation>
    </message>
    <message>
        <source>two sets of axes of a control group</source>
        <translation>一个控制轴组的两组轴</translation>
    </message>
    <message>
        <source>axes of a control group and a number</source>
        <translation>一个控制轴组的轴和一个数</translation>
    </message>
    <message>
        <source>control group and a number</source>
        <translation>控制轴组和一个数</translation>
    </message>
    <message>
        <source>unknown type %1</source>
        <translation>未知类型 %1</translation>
    </message>
    <message>
        <source>front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>back</source>
        <translation>背面</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>上方手臂</translation>
    </message>
    <message>
        <source>lower arm</source>
        <translation>下方手臂</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>翻转</translation>
    </message>
    <message>
        <source>no flip</source>
        <translation>不翻转</translation>
    </message>
    <message>
        <source>R &lt; 180</source>
        <translation>R &lt; 180</translation>
    </message>
    <message>
        <source>R &gt;= 180</source>
        <translation>R &gt;= 180</translation>
    </message>
    <message>
        <source>T &lt; 180</source>
        <translation>T &lt; 180</translation>
    </message>
    <message>
        <source>T &gt;= 180</source>
        <translation>T &gt;= 180</translation>
    </message>
    <message>
        <source>S &lt; 180</source>
        <translation>S &lt; 180</translation>
    </message>
    <message>
        <source>S &gt;= 180</source>
        <translation>S &gt;= 180</translation>
    </message>
    <message>
        <source>redundant front</source>
        <translation>冗余正面</translation>
    </message>
    <message>
        <source>redundant back</source>
        <translation>冗余背面</translation>
    </message>
    <message>
        <source>previous step&apos;s form</source>
        <translation>前一程序点的形态</translation>
    </message>
    <message>
        <source>this form</source>
        <translation>此形态</translation>
    </message>
    <message>
        <source>L &lt; 180</source>
        <translation>L &lt; 180</translation>
    </message>
    <message>
        <source>L &gt;= 180</source>
        <translation>L &gt;= 180</translation>
    </message>
    <message>
        <source>U &lt; 180</source>
        <translation>U &lt; 180</translation>
    </message>
    <message>
        <source>U &gt;= 180</source>
        <translation>U &gt;= 180</translation>
    </message>
    <message>
        <source>B &lt; 180</source>
        <translation>B &lt; 180</translation>
    </message>
    <message>
        <source>B &gt;= 180</source>
        <translation>B &gt;= 180</translation>
    </message>
    <message>
        <source>E &lt; 180</source>
        <translation>E &lt; 180</translation>
    </message>
    <message>
        <source>E &gt;= 180</source>
        <translation>E &gt;= 180</translation>
    </message>
    <message>
        <source>W &lt; 180</source>
        <translation>W &lt; 180</translation>
    </message>
    <message>
        <source>W &gt;= 180</source>
        <translation>W &gt;= 180</translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>脉冲</translation>
    </message>
    <message>
        <source>base frame</source>
        <translation>基座坐标</translation>
    </message>
    <message>
        <source>robot frame</source>
        <translation>机器人坐标</translation>
    </message>
    <message>
        <source>user frame</source>
        <translation>用户坐标</translation>
    </message>
    <message>
        <source>tool frame</source>
        <translation>工具坐标</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>组 %1</translation>
    </message>
    <message numerus="yes">
        <source>… (%n more characters)</source>
        <translation>
            <numerusform>…（另有 %n 个字符）</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>variables::Sentences</name>
    <message>
        <source>Line %1: a cell begins with a quotation mark and does not end with one.</source>
        <translation>第 %1 行：单元格以引号开头，但没有以引号结尾。</translation>
    </message>
    <message>
        <source>Line %1: there is text behind the quotation mark that ends a cell.</source>
        <translation>第 %1 行：单元格的结束引号之后还有文本。</translation>
    </message>
    <message>
        <source>The file is not UTF-8: save it as “CSV UTF-8” and try again.</source>
        <translation>该文件不是 UTF-8：请另存为“CSV UTF-8”后重试。</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>“%1”不是数。</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be from %2 to %3.</source>
        <translation>%1 超出范围：必须为 %2 至 %3。</translation>
    </message>
    <message>
        <source>“%1” is not a whole number: write it without decimals and separators.</source>
        <translation>“%1”不是整数：请不带小数和分隔符书写。</translation>
    </message>
    <message>
        <source>%1 does not go into a real: that is 0, or from ±1.18e-38 to ±3.40e+38.</source>
        <translation>%1 不能存为实数：实数为 0，或 ±1.18e-38 至 ±3.40e+38。</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>不是数</translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>“%1”不是整数。</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is too fine: %n decimal(s) are kept.</source>
        <translation>
            <numerusform>“%1”过于精细：保留 %n 位小数。</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” is not a variable. Write its letter and its number, such as B007.</source>
        <translation>“%1”不是变量。请写字母和编号，例如 B007。</translation>
    </message>
    <message>
        <source>There is no %1: this controller has %2 to %3.</source>
        <translation>没有 %1：此控制器有 %2 至 %3。</translation>
    </message>
    <message>
        <source>“%1” is not a range: it must go from a lower to a higher number of one kind.</source>
        <translation>“%1”不是范围：必须为同一种类从较小编号到较大编号。</translation>
    </message>
    <message>
        <source>“%1” is not a type that %2 has.</source>
        <translation>%2 没有类型“%1”。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>column: reason</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 is missing, and no value of this type was read.</source>
        <translation>缺少 %1，且未读取到此类型的值。</translation>
    </message>
    <message>
        <source>The type is missing, and none was read.</source>
        <translation>缺少类型，且未读取到类型。</translation>
    </message>
    <message>
        <source>The variable is missing.</source>
        <translation>缺少变量。</translation>
    </message>
    <message>
        <source>%1 can only be read.</source>
        <translation>%1 只能读取。</translation>
    </message>
    <message>
        <source>%1 stands in line %2 already.</source>
        <translation>%1 已在第 %2 行中。</translation>
    </message>
    <message>
        <source>The value is missing.</source>
        <translation>缺少值。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>variable: reason</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>The column “%1” stands there twice.</source>
        <translation>列“%1”出现了两次。</translation>
    </message>
    <message>
        <source>The header is missing: the first line must name the columns “variable” and “value”.</source>
        <translation>缺少表头：第一行必须写明列“variable”和“value”。</translation>
    </message>
    <message>
        <source>There is neither a column “value” nor “axis 1”.</source>
        <translation>既没有列“value”，也没有列“axis 1”。</translation>
    </message>
    <message>
        <source>The line has more cells than the header.</source>
        <translation>该行的单元格多于表头。</translation>
    </message>
    <message>
        <source>A block without a header has one or two columns.</source>
        <translation>没有表头的数据块应有一列或两列。</translation>
    </message>
    <message>
        <source>The text cannot be sent: %1.</source>
        <translation>无法发送该文本：%1。</translation>
    </message>
    <message>
        <source>The text must not hold the character NUL, which ends it.</source>
        <translation>文本中不得含有字符 NUL，该字符表示文本结束。</translation>
    </message>
    <message>
        <source>The text takes %1 bytes; there is room for %2.</source>
        <translation>文本需要 %1 字节；可用空间为 %2。</translation>
    </message>
    <message>
        <source>A position is not written as one text.</source>
        <translation>位置不能作为单个文本写入。</translation>
    </message>
    <message>
        <source>a real number</source>
        <translation>实数</translation>
    </message>
    <message numerus="yes">
        <source>up to %n byte(s)</source>
        <translation>
            <numerusform>最多 %n 字节</numerusform>
        </translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>脉冲</translation>
    </message>
</context>
<context>
    <name>widgets::ArmControl</name>
    <message>
        <source>Hold for 1 s to arm</source>
        <translation>按住 1 s 以激活</translation>
    </message>
    <message>
        <source>Why not?</source>
        <translation>为什么不可以？</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>取消激活</translation>
    </message>
    <message>
        <source>Nobody is inside the fence</source>
        <translation>安全围栏内没有人</translation>
    </message>
    <message>
        <source>I see the robot, or somebody who does</source>
        <translation>我能看到机器人，或有能看到机器人的人</translation>
    </message>
    <message>
        <source>An emergency stop is within reach there</source>
        <translation>那里的急停在伸手可及之处</translation>
    </message>
    <message>
        <source>Armed: start, servo on and moves are possible. It drops after a minute without key or mouse.</source>
        <translation>已激活：可以启动、接通伺服和移动。一分钟内无键盘或鼠标操作，将自动取消激活。</translation>
    </message>
    <message>
        <source>Disarmed at %1: %2.</source>
        <translation>已于 %1 取消激活：%2。</translation>
    </message>
    <message>
        <source>Tick all three first.</source>
        <translation>请先勾选全部三项。</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
</context>
<context>
    <name>widgets::CellEditor</name>
    <message>
        <source>live: %1</source>
        <translation>实时：%1</translation>
    </message>
</context>
<context>
    <name>widgets::ConditionList</name>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>widgets::ControllerTile</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
</context>
<context>
    <name>widgets::DiffView</name>
    <message>
        <source>Lines of both versions</source>
        <translation>两个版本的行</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Older</source>
        <translation>较旧</translation>
    </message>
    <message>
        <source>Newer</source>
        <translation>较新</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>另外 %n 项</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::GoToEdit</name>
    <message>
        <source>Go to</source>
        <translation>转到</translation>
    </message>
    <message>
        <source>Go to…  Ctrl+G</source>
        <translation>转到…  Ctrl+G</translation>
    </message>
</context>
<context>
    <name>widgets::HoldButton</name>
    <message>
        <source>HOLD</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD（软件）</translation>
    </message>
    <message>
        <source>software hold · Pause key</source>
        <translation>软件 HOLD · Pause 键</translation>
    </message>
</context>
<context>
    <name>widgets::JobView</name>
    <message>
        <source>Job text</source>
        <translation>程序内容</translation>
    </message>
</context>
<context>
    <name>widgets::JogPad</name>
    <message>
        <source>Jog %1 forward</source>
        <translation>点动 %1 正向</translation>
    </message>
    <message>
        <source>Jog %1 back</source>
        <translation>点动 %1 反向</translation>
    </message>
</context>
<context>
    <name>widgets::LogicStrip</name>
    <message>
        <source>The watched signals over the last minute</source>
        <translation>最近一分钟内关注的信号</translation>
    </message>
    <message>
        <source>now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>−%1 s</source>
        <translation>−%1 s</translation>
    </message>
</context>
<context>
    <name>widgets::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>关闭此信息</translation>
    </message>
</context>
<context>
    <name>widgets::OrderButton</name>
    <message>
        <source>Why not?</source>
        <translation>为什么不可以？</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Conditions of: %1</source>
        <translation>条件：%1</translation>
    </message>
    <message>
        <source>Pending…</source>
        <translation>等待中…</translation>
    </message>
</context>
<context>
    <name>widgets::Plot</name>
    <message>
        <source>seconds</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Nothing is plotted.</source>
        <translation>没有绘制曲线。</translation>
    </message>
</context>
<context>
    <name>widgets::Plottables</name>
    <message>
        <source>Add to trend: %1</source>
        <translation>添加到趋势：%1</translation>
    </message>
</context>
<context>
    <name>widgets::Question</name>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
</context>
<context>
    <name>widgets::Rows</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>widgets::Segments</name>
    <message>
        <source>%1: %2</source>
        <comment>what is chosen: the choice</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>widgets::Sparkline</name>
    <message>
        <source>Round trips of the last 60 seconds: none yet.</source>
        <translation>最近 60 秒的往返时间：尚无。</translation>
    </message>
    <message>
        <source>Round trips of the last 60 seconds: longest %1 ms, lost tries in %2 s.</source>
        <translation>最近 60 秒的往返时间：最长 %1 ms，在 %2 s 内有丢失的尝试。</translation>
    </message>
</context>
<context>
    <name>widgets::ToolPathView</name>
    <message>
        <source>Top</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前视</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧视</translation>
    </message>
    <message>
        <source>Tool path, %1 view</source>
        <translation>工具轨迹，%1图</translation>
    </message>
    <message>
        <source>No position in the base frame was read yet.</source>
        <translation>尚未读取到基座坐标下的位置。</translation>
    </message>
    <message>
        <source>%1 %2 mm, %3 %4 mm. %5</source>
        <translation>%1 %2 mm，%3 %4 mm。%5</translation>
    </message>
    <message>
        <source>%1  ·  %2 →  %3 ↑</source>
        <translation>%1  ·  %2 →  %3 ↑</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>widgets::ValueGrid</name>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
</context>
<context>
    <name>widgets::ValueLabel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1。%2</translation>
    </message>
</context>
</TS>
